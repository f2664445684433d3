// The team's strategy: the captain's own choice, or the newest choice heard from the captain.
#pragma once

#include <cstdint>

#include "proto/foresight/team.pb.h"
#include "robot/bridge/moment.h"
#include "sim/agent/choice.h"
#include "sim/math/tick.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// The rule of sim/agent/choice.h, which the simulator's teams follow too. Used by one thread.
class Following {
 public:
  /// Game time after which an unconfirmed choice is dropped [ns].
  static constexpr std::uint64_t kStaleNs = 20'000'000'000;
  static constexpr sim::Tick kStaleTicks = kStaleNs * 30 / 1'000'000'000;  // the same [ticks]

  /// `strategies` is the number of strategies in the robot's list [1..8].
  explicit Following(int strategies) : strategies_(strategies) {}

  /// Takes over the choice in the teammates' messages. `captain` is the player that chooses, 0
  /// for none; `player` is this robot.
  void hear(const pb::Team& team, int captain, int player, const bridge::Moment& now);

  /// Drops a stale choice. A robot that asks every `period_ns` of game time keeps it that much longer. After time was
  /// moved back it also drops choices of the future. Call it regularly.
  void forget(const bridge::Moment& now, std::uint64_t period_ns = 0);

  /// Sets the captain's own choice, or confirms it when it is the same.
  void choose(int strategy, std::uint64_t told_ns);

  const sim::agent::Choice& choice() const { return choice_; }
  std::uint64_t told_ns() const { return told_ns_; }

 private:
  const int strategies_;
  sim::agent::Choice choice_;
  std::uint64_t told_ns_ = 0;
};

}  // namespace robot::foreseeing
