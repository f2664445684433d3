// Learned policies as JSON: a net that chooses between the rules of a menu.
//
//   {
//     "name": "striker",
//     "about": "learned in the drill run_to_score",
//     "based_on": "baseline",                  // settings, parameters and subtrees, as of a strategy
//     "menu": [                                // rules as of a strategy (sim/io/strategy.h), 1 .. 64
//       { "do": "kick", "with": { "aim": "goal" } },
//       { "use": "chaser" }
//     ],
//     "inputs": ["ball_distance", "role"],     // features; without it, all built-in ones
//     "net": {
//       "layers": [                            // 1 .. 8
//         { "weights": [[0.1, …], …], "bias": [0, …], "activation": "tanh" },   // or "relu"; a row per output
//         { "weights": [[…], …], "bias": [0, 0], "activation": "none" }
//       ]
//     }
//   }
//
// The features become the columns of sim/agent/columns.h. Without "net" the description is a frame: the choices and
// observations of a learner.
#pragma once

#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/agent/policy.h"
#include "sim/io/json.h"

namespace sim::io {

/// Reads a frame, which may have a net.
robot::Result<agent::Frame> read_frame(const Json& policy, const std::string& called);

/// Parses a policy with its net. The Error names the place: "strategy 'mine.json': net.layers[0].bias must have 8 …".
robot::Result<agent::PolicyBehaviour> parse_policy(std::string_view text, const std::string& called);

}  // namespace sim::io
