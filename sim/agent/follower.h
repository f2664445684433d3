// A team that plays the strategy that its captain chose.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/agent/behaviour.h"
#include "sim/agent/choice.h"

namespace sim::agent {

/// The behaviour of a robot that follows the newest choice it heard, by the rule of choice.h. Two robots may disagree
/// for as long as their messages take. The mind is the only memory.
class Follower final : public Behaviour {
 public:
  /// `strategies` has at least one. The first is played until a captain chooses, and again when the captain has been
  /// silent for `stale` [ticks], at most half an hour.
  Follower(std::string name, std::vector<std::shared_ptr<const Behaviour>> strategies, Tick stale);

  const std::string& name() const override { return name_; }
  motion::Command decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                         Mind& mind, Trace* trace) const override;

  /// Returns what a robot with that choice plays.
  const std::shared_ptr<const Behaviour>& strategy(const Choice& choice) const {
    return strategies_[static_cast<std::size_t>(choice.played())];
  }

  /// The two halves of a decision: hear() takes over the teammates' choice, play() plays it. A robot that `leads` keeps
  /// its own choice.
  void hear(const Game& game, const Beliefs& beliefs, Tick now, Mind& mind, bool leads) const;
  motion::Command play(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now, Mind& mind,
                       Trace* trace) const;

 private:
  const std::string name_;
  const std::vector<std::shared_ptr<const Behaviour>> strategies_;
  const Tick stale_;
};

/// Sets the choice that a robot follows from now on. Forgets the leaf of another tree.
void take_over(const Choice& choice, Tick now, Mind& mind);

/// Returns the ticks since a time given by its lower 16 bits: at most 36 min.
constexpr Tick since(Tick now, std::uint16_t then) { return static_cast<std::uint16_t>(now - then); }

/// Returns the number [1..7] of the captain, or 0 for none, as this robot believes: the playing field player with the
/// lowest number. A teammate counts when it was heard within `stale` [ticks].
int captain_of(const Game& game, const Beliefs& beliefs, Tick now, Tick stale);

}  // namespace sim::agent
