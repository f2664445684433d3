// The time of a recording that is being played.
#pragma once

#include <cstdint>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/logging/streams/parser.h"

namespace robot::body {

/// Runs from the start of a recording to its end at a given speed, then stands still; may be paused and moved. Tells
/// parsers when a message is due. Capture times stay those of the recording, so what is played looks as it did when it
/// was live. Any thread.
class PlaybackClock final : public Clock, public logging::Pace {
 public:
  /// `start_ns`, `end_ns`: capture times [ns since the epoch]; `speed` > 0, 1 is real time. Stands at the start.
  PlaybackClock(std::uint64_t start_ns, std::uint64_t end_ns, double speed)
      : start_ns_(start_ns), end_ns_(end_ns), speed_(speed), from_ns_(start_ns) {}

  /// Begins to run.
  void start();

  /// Lets every waiting parser end, now and later. Stands at the end.
  void stop();

  /// Runs or stands from now on, and when it runs, at `speed`.
  void set(bool running, double speed);

  /// Goes on at `to_ns`, or at the end of the recording that is nearest to it: every parser goes there.
  void seek(std::uint64_t to_ns);

  bool running() const;
  double speed() const;

  /// How many parsers have carried their streams to the end since the last seek.
  std::size_t parsers_at_end() const;

  std::uint64_t now_ns() const override;
  Due wait_until_due(std::uint64_t capture_ns, std::uint64_t moves) override;
  Due wait_for_move(std::uint64_t moves) override;
  Move last_move() const override;

 private:
  std::uint64_t position_ns() const;
  void set_position(std::uint64_t position_ns);

  const std::uint64_t start_ns_, end_ns_;

  mutable Mutex lock_;
  Condition changed_;
  double speed_;
  bool running_ = false, stopped_ = false;
  std::uint64_t from_ns_;       // the position when it began to run, or where it stands
  std::uint64_t since_ns_ = 0;  // [monotonic] when that was
  Move move_{.count = 0, .to_ns = 0};
  std::size_t at_end_ = 0;
};

}  // namespace robot::body
