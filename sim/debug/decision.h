// One decision of a robot, taken out of a game with everything on which it depended.
#pragma once

#include <optional>

#include "sim/agent/tree.h"
#include "sim/debug/timeline.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::debug {

/// The arguments of one call of Behaviour::decide.
struct Decision {
  int robot = 0;  // index
  Tick tick = 0;
  agent::Game game;
  agent::Beliefs beliefs;
  agent::Mind mind;  // before the decision
};

/// Reports whether the robot decides in the tick that begins with `state`.
bool decides(const State& state, int robot);

/// Returns the decision of the robot in the tick that begins with `state`, or nothing if it does not decide then.
std::optional<Decision> decision_in(const Params& params, const State& state, int robot);

/// Returns the robot's newest decision in or before `tick`, or nothing if it has not decided yet. `tick` is played.
std::optional<Decision> decision_before(Timeline& timeline, Tick tick, int robot);

/// The result of a decision.
struct Outcome {
  motion::Command command;
  agent::Mind mind;  // after the decision
};

/// Decides again, with any tree. `trace` may be nullptr.
Outcome decide(const Params& params, const agent::Behaviour& behaviour, const Decision& decision,
               agent::Trace* trace = nullptr);

/// A decision just before its first comparison. Features have the values that the robot compared.
class Thought {
 public:
  /// `params` and `tree` outlive it.
  Thought(const Params& params, const agent::Tree& tree, const Decision& decision);
  Thought(const Thought&) = delete;
  Thought& operator=(const Thought&) = delete;

  const agent::View& view() const { return view_; }
  /// Returns the memory after the robot remembered the ball and took its role.
  const agent::Mind& mind() const { return mind_; }

 private:
  Decision decision_;
  agent::Surroundings around_;
  agent::Mind mind_;
  agent::View view_;
};

}  // namespace sim::debug
