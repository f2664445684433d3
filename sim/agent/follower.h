// A team that plays whichever of its strategies its captain chose.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/agent/behaviour.h"

namespace sim::agent {

/// Each robot follows the newest choice that it heard, by the rule of choice.h. So two robots may disagree for as long as
/// their messages take. Remembers in the mind alone.
class Follower final : public Behaviour {
 public:
  /// `strategies`, at least one; the first is played as long as nobody chose, and again once the captain was silent for
  /// `stale` [ticks], at most half an hour.
  Follower(std::string name, std::vector<std::shared_ptr<const Behaviour>> strategies, Tick stale);

  const std::string& name() const override { return name_; }
  motion::Command decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                         Mind& mind, Trace* trace) const override;

  /// The two halves of a decision: takes over what teammates told, and plays what is chosen. Whoever `leads` keeps its own
  /// choice.
  void hear(const Game& game, const Beliefs& beliefs, Tick now, Mind& mind, bool leads) const;
  motion::Command play(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now, Mind& mind,
                       Trace* trace) const;

 private:
  const std::string name_;
  const std::vector<std::shared_ptr<const Behaviour>> strategies_;
  const Tick stale_;
};

/// Sets what a robot follows, of now. The leaves of another tree are other leaves.
void take_over(const Choice& choice, Tick now, Mind& mind);

/// Ticks since a moment of which the lower 16 bits are known: at most 36 min.
constexpr Tick since(Tick now, std::uint16_t then) { return static_cast<std::uint16_t>(now - then); }

/// [1..7] the captain, as a robot believes: the field player of the lowest number that plays, itself or a teammate that
/// told so within `stale` [ticks]. 0: nobody.
int captain_of(const Game& game, const Beliefs& beliefs, Tick now, Tick stale);

}  // namespace sim::agent
