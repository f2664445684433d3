// The clock of a recording during playback.
#pragma once

#include <cstdint>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/logging/streams/parser.h"

namespace robot::body {

/// The playhead of a recording. It runs from the start to the end at a given speed, then stops there; it may be paused
/// and moved. Parsers wait on it until a message is due. Messages keep their recorded capture times, so a played
/// recording looks as it did live. Any thread.
class PlaybackClock final : public Clock, public logging::Pace {
 public:
  /// `start_ns` and `end_ns` are capture times [ns since the epoch]. `speed` > 0, 1 is real time. Begins paused at the
  /// start.
  PlaybackClock(std::uint64_t start_ns, std::uint64_t end_ns, double speed)
      : start_ns_(start_ns), end_ns_(end_ns), speed_(speed), from_ns_(start_ns) {}

  /// Starts to run.
  void start();

  /// Ends every waiting parser, now and later. Moves the playhead to the end.
  void stop();

  /// Runs at `speed`, or pauses.
  void set(bool running, double speed);

  /// Moves the playhead and every parser to `to_ns`, limited to the range of the recording.
  void seek(std::uint64_t to_ns);

  /// Ends the waits of all parsers, as a move to the present time does.
  void look_again();

  bool running() const;
  double speed() const;

  /// Returns the number of parsers that have reached the end of their streams since the last seek.
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
  std::uint64_t from_ns_;       // position at `since_ns_`, or the position while paused
  std::uint64_t since_ns_ = 0;  // [monotonic clock] start of running
  Move move_{.count = 0, .to_ns = 0};
  std::size_t at_end_ = 0;
};

}  // namespace robot::body
