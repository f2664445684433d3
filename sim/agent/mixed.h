// A team with two behaviours: for measuring the value of a change to some of its robots.
#pragma once

#include <string>

#include "sim/agent/behaviour.h"

namespace sim::agent {

/// The behaviour of players 1 .. `changed` is `first`, of the others `rest`. Both outlive this object.
class Mixed final : public Behaviour {
 public:
  Mixed(const Behaviour& first, int changed, const Behaviour& rest);

  const std::string& name() const override { return name_; }
  motion::Command decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                         Mind& mind, Trace* trace) const override;
  /// Returns the behaviour of a player, by its number.
  const Behaviour& of(int player) const { return player <= changed_ ? first_ : rest_; }

 private:
  const Behaviour& first_;
  const Behaviour& rest_;
  const int changed_;
  const std::string name_;
};

}  // namespace sim::agent
