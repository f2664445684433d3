// A team of which some players decide differently from the others: what a change to one robot's behaviour is worth.
#pragma once

#include <string>

#include "sim/agent/behaviour.h"

namespace sim::agent {

/// Players 1 .. `changed` play `first`, the others `rest`; both outlive it.
class Mixed final : public Behaviour {
 public:
  Mixed(const Behaviour& first, int changed, const Behaviour& rest);

  const std::string& name() const override { return name_; }
  motion::Command decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                         Mind& mind, Trace* trace) const override;

 private:
  const Behaviour& first_;
  const Behaviour& rest_;
  const int changed_;
  const std::string name_;
};

}  // namespace sim::agent
