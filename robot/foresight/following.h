// What the team plays: this robot's own choice where it is the captain, else the newest that it heard.
#pragma once

#include <cstdint>

#include "proto/foresight/team.pb.h"
#include "robot/bridge/moment.h"
#include "sim/agent/choice.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// Plain data with the rule of sim/agent/choice.h: the simulator's teams follow by the same one. Used by one thread.
class Following {
 public:
  /// A choice that was not confirmed for longer, in game time, is not followed.
  static constexpr std::uint64_t kStaleNs = 20'000'000'000;

  /// `strategies` [1..8] in the robot's list.
  explicit Following(int strategies) : strategies_(strategies) {}

  /// Takes over what teammates told. `captain` chooses, 0: nobody; `player` is this robot.
  void hear(const pb::Team& team, int captain, int player, const bridge::Moment& now);

  /// Lets go of a choice that is stale; where this robot asks every `period_ns` of game time itself, that much later.
  /// Where time was moved back, of one that is still to come and of what was before it. To be called now and then.
  void forget(const bridge::Moment& now, std::uint64_t period_ns = 0);

  /// As the captain; confirms what is played when it is the same.
  void choose(int strategy, std::uint64_t told_ns);

  const sim::agent::Choice& choice() const { return choice_; }
  std::uint64_t told_ns() const { return told_ns_; }

 private:
  const int strategies_;
  sim::agent::Choice choice_;
  std::uint64_t told_ns_ = 0;
};

}  // namespace robot::foreseeing
