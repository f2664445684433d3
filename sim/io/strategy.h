// Strategies as JSON: a decision tree, its parameters, and the roles of the team.
//
//   {
//     "name": "careful",
//     "about": "waits for a good look",
//     "based_on": "baseline",                      // optional: the source of all missing entries
//     "parameters": { "near": "0.35 m", "aim": "goal" },
//     "roles": { "hysteresis": 1 },                // sim/agent/settings.h, likewise "habits"
//     "formation": { "ours": [[-0.95, 0], …], "theirs": [[-0.95, 0], …] },
//     "tree": [                                    // the first rule whose condition holds
//       { "if": "not ball_known", "do": "search_ball" },
//       { "if": "role is keeper and ball_distance < $near", "use": "clear" },
//       { "if": "ball_bearing > 20 deg or ball_bearing < -20 deg", "then": { … }, "else": { … } },
//       { "do": "kick", "with": { "aim": "$aim", "tolerance": "10 deg" } }
//     ],
//     "subtrees": { "clear": … }
//   }
//
// A rule is a list of rules, or an object: "if" (optional) with "then", "do" (a skill, "with" its arguments) or "use"
// (a subtree). If the condition fails, "else" is next; without "else" the next rule of the list. Conditions
// compare a feature by < <= > >= is, is not; a yes-or-no feature stands alone. A feature may also be compared with
// another one of the same unit: "mates_time_to_ball < time_to_ball". "not" stands before one comparison; "and" binds
// closer than "or". A comparison with an unknown value is false, with and without "not". Values are numbers in SI, or
// with deg, cm or min. Every rule may have a "name" for the trace, and an "about".
//
// Numbers, rules and the strategy may have marks for a learner: "learn" (sim/io/marks.h).
//
// The tables of features and skills are in sim/agent/features.cpp and sim/agent/skills.cpp. `foresight-sim features` and
// `foresight-sim skills` print them.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/agent/tree.h"
#include "sim/io/json.h"
#include "sim/match/params.h"

namespace sim::io {

/// Parses the tree in `text`. `called` opens the sentence of an Error, which names the place:
/// "strategy 'mine': tree[2].if: no feature "bal_age"; did you mean 'ball_age'?"
robot::Result<agent::Tree> parse_strategy(std::string_view text, const std::string& called);

/// Returns the description in `text` with all that it takes over from its bases, and with its marks (sim/io/marks.h).
robot::Result<Json> flattened(std::string_view text, const std::string& called);

/// Parses a strategy with a "menu", a list of rules, instead of a "tree". Settings, parameters and subtrees may come from
/// "based_on". Fills Tree.menu.
robot::Result<agent::Tree> parse_menu(const Json& strategy, const std::string& called);

/// Loads an embedded strategy by name, or a file by path; changed parameters follow behind commas: "baseline,near=0.3".
robot::Result<std::unique_ptr<agent::TreeBehaviour>> load_strategy(const std::string& name);

/// Returns an Error if a leaf of the tree names a kick that a robot of the team lacks. Its sentence has similar names:
/// "strategy 'mine': models 'match' have no kick "sid"; did you mean 'side'?"
robot::Result<void> check_kicks(const agent::Tree& tree, const Team& team);

}  // namespace sim::io
