// The due times of the ticks of a simulated game.
#pragma once

#include <cstdint>

#include "robot/core/clock.h"

namespace robot::body {

/// A pacer at a constant rate without drift: the thousandth tick is due a thousand periods after the start, regardless
/// of delays on the way. Pure: times are given. Used by one thread at a time.
class Pacer {
 public:
  /// [game seconds per second]
  static constexpr double kSlowest = 0.1, kFastest = 100;

  /// Greatest delay that a game catches up with. A longer delay is cut to this one, and the difference is counted.
  static constexpr std::uint64_t kPatienceNs = kSecond / 10;

  /// Sets the speed. The next tick is due one period after `now_ns` [monotonic].
  void restart(double speed, std::uint64_t now_ns);

  /// Returns the due time of the next tick [ns, monotonic].
  std::uint64_t next_ns() const { return due_ns(taken_ + 1); }

  /// Takes the next tick, which must be due at `now_ns`. Returns its due time, at most kPatienceNs and one period
  /// earlier.
  std::uint64_t take(std::uint64_t now_ns);

  double speed() const { return speed_; }

  /// Returns the delay that the game did not catch up with since the beginning [ticks].
  std::uint64_t ticks_behind() const { return ticks_behind_; }

 private:
  std::uint64_t due_ns(std::uint64_t tick) const;

  double speed_ = 1;
  double period_ns_ = 1;
  std::uint64_t start_ns_ = 0, taken_ = 0;
  std::uint64_t ticks_behind_ = 0;
};

}  // namespace robot::body
