// How an agent decides: beliefs in, command out.
#pragma once

#include <string>

#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/field/field.h"
#include "sim/motion/command.h"
#include "sim/motion/model.h"

namespace sim::agent {

/// What does not change during a game and the agent knows.
struct Surroundings {
  const field::Field* field;
  const motion::Model* motion;  // what the own body can do
};

struct Trace;  // why it decided so: sim/agent/trace.h

/// Something that decides for a robot. Immutable: shared by all robots and threads that play it.
class Behaviour {
 public:
  virtual ~Behaviour() = default;
  virtual const std::string& name() const = 0;
  /// One decision at time `now`. A function of its arguments only; remembers through `mind`, explains into `trace`
  /// (nullptr: nobody asks, and then nothing is allocated).
  virtual motion::Command decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs, Tick now,
                                 Mind& mind, Trace* trace) const = 0;
};

}  // namespace sim::agent
