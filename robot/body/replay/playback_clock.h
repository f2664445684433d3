// The time of a recording that is being played.
#pragma once

#include <cstdint>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/logging/parser.h"

namespace robot::body {

/// Runs from the start of a recording to its end at a given speed, then stands still; tells parsers when a message is
/// due. Capture times stay those of the recording, so what is played looks as it did when it was live. Any thread.
class PlaybackClock final : public Clock, public logging::Pace {
 public:
  /// `start_ns`, `end_ns`: capture times [ns since the epoch]; `speed` > 0, 1 is real time. Stands at the start.
  PlaybackClock(std::uint64_t start_ns, std::uint64_t end_ns, double speed)
      : start_ns_(start_ns), end_ns_(end_ns), speed_(speed) {}

  /// Begins at the start, also if it ran before.
  void start();

  /// Lets every waiting parser go, now and later, until start().
  void stop();

  std::uint64_t now_ns() const override;
  bool wait_until_due(std::uint64_t capture_ns) override;

 private:
  std::uint64_t due_ns(std::uint64_t capture_ns) const;

  const std::uint64_t start_ns_, end_ns_;
  const double speed_;

  mutable Mutex lock_;
  Condition changed_;
  bool running_ = false;
  std::uint64_t started_ns_ = 0;  // [monotonic]
};

}  // namespace robot::body
