// Teams that choose their strategy by foresight, as JSON:
//
//   {
//     "name": "foresight",
//     "about": "its purpose",
//     "choose": ["baseline", "passing"],   // 2 .. 8 decision trees; the first is the default
//     "opponent": "baseline",              // assumed strategy of the opponents
//     "opponent_models": "match",          // and their assumed models; default: the true ones
//     "rollouts": 64,                      // sim/foresight/chooser.h, likewise "horizon", "period", "stale" [s],
//     "horizon": { "value": 20, "unit": "s" }   // "switching_cost" [goals] and "sure"
//   }
#pragma once

#include <memory>
#include <string>

#include "robot/core/result.h"
#include "sim/agent/behaviour.h"
#include "sim/io/matchup.h"
#include "sim/world/world.h"

namespace sim::io {

/// Loads the behaviour of `side` in that game: a decision tree, a team that chooses between several, or a learned
/// policy (sim/io/policy.h). `name` is embedded or a path; changes follow behind commas: "foresight,horizon=30".
robot::Result<std::shared_ptr<const agent::Behaviour>> load_behaviour(const std::string& name, const Matchup& game,
                                                                      Side side);

}  // namespace sim::io
