// Teams that choose their strategy by foresight, as JSON:
//
//   {
//     "name": "foresight",
//     "about": "what it is for",
//     "choose": ["baseline", "passing"],   // 2 .. 8 decision trees; the first is played at first
//     "opponent": "baseline",              // what the others are taken to play
//     "opponent_models": "match",          // and to be able to; without it: as they are
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

/// What `side` of that game plays: a decision tree, or a team that chooses between some; embedded by name or a file by
/// path, behind commas what differs: "foresight,horizon=30".
robot::Result<std::shared_ptr<const agent::Behaviour>> load_behaviour(const std::string& name, const Matchup& game,
                                                                      Side side);

}  // namespace sim::io
