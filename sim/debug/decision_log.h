// All decisions of a robot in a game, one after the other.
#pragma once

#include <functional>
#include <optional>

#include "sim/debug/decision.h"
#include "sim/debug/evaluation.h"

namespace sim::debug {

/// A decision with what the tree made of it.
struct LoggedDecision {
  Decision decision;
  const char* skill = "";  // that the robot plays, also outside play
  const char* role = "";
  Values values;                         // of the features that the tree reads; empty outside play
  std::optional<Evaluation> evaluation;  // in play
};

/// Plays on from `state` to the end, or for at most `most` ticks. Calls see(decision, state) for each decision of the
/// robot in order; `state` is that of its tick. `behaviour` is that of the robot.
void for_each_decision(const Params& params, State state, int robot, const agent::TreeBehaviour& behaviour, Tick most,
                       const std::function<void(const LoggedDecision&, const State&)>& see);

}  // namespace sim::debug
