// Marks in a strategy: the parts that a learner may change (sim/learn). A game ignores them.
//
//   "near_ball": { "value": "0.5 m", "learn": [0.2, 1.5] }              a number with its range, in the same unit
//   { "name": "free", "do": "kick", "learn": [ { "do": "dribble" } ] }  a leaf with other actions for it
//   "learn": { "conditions": ["opponent_ball_distance"] }               of the strategy: the features of new conditions
#pragma once

#include "robot/core/result.h"
#include "sim/io/json.h"

namespace sim::io {

/// Returns the strategy, or a part of it, without its marks. The Error names the place of a wrong mark:
/// "parameters.near_ball.learn must be a range [least, most], got [2, 1]".
robot::Result<Json> without_marks(const Json& strategy);

}  // namespace sim::io
