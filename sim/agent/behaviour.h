// The decisions of an agent: beliefs in, command out.
#pragma once

#include <string>

#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/field/rules.h"
#include "sim/motion/command.h"
#include "sim/motion/model.h"

namespace sim::agent {

/// The agent's knowledge that does not change during a game.
struct Surroundings {
  const field::Rules* rules;
  const motion::Model* motion;  // of the own body
};

struct Trace;  // the reasons of a decision: sim/agent/trace.h

/// The decision function of a robot. Immutable: all robots and threads that play it share it.
class Behaviour {
 public:
  virtual ~Behaviour() = default;
  virtual const std::string& name() const = 0;
  /// Decides at time `now`. The result depends on the arguments only. `mind` is the memory between decisions. `trace`
  /// receives the reasons; with nullptr nothing is allocated.
  virtual motion::Command decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                                 Mind& mind, Trace* trace) const = 0;
};

}  // namespace sim::agent
