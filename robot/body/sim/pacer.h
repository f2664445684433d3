// When the ticks of a simulated game are due.
#pragma once

#include <cstdint>

#include "robot/core/clock.h"

namespace robot::body {

/// Evenly, without drift: the thousandth tick is due a thousand periods after the start, whatever the delays on the
/// way. Pure: times are given. Used by one thread at a time.
class Pacer {
 public:
  /// [game seconds per second]
  static constexpr double kSlowest = 0.1, kFastest = 100;

  /// A game that is further behind than this does not race after it: the rest is counted and given up.
  static constexpr std::uint64_t kPatienceNs = kSecond / 10;

  /// From now on the ticks come at `speed`, the next one a period after `now_ns` [monotonic].
  void restart(double speed, std::uint64_t now_ns);

  /// When the next tick is due. [monotonic]
  std::uint64_t next_ns() const { return due_ns(taken_ + 1); }

  /// Takes the next tick, which is due at `now_ns`: when it was due, at most kPatienceNs and a period ago.
  std::uint64_t take(std::uint64_t now_ns);

  double speed() const { return speed_; }

  /// By how many ticks the game is behind what was asked for, since the beginning.
  std::uint64_t ticks_behind() const { return ticks_behind_; }

 private:
  std::uint64_t due_ns(std::uint64_t tick) const;

  double speed_ = 1;
  double period_ns_ = 1;
  std::uint64_t start_ns_ = 0, taken_ = 0;
  std::uint64_t ticks_behind_ = 0;
};

}  // namespace robot::body
