// The reasons of a decision as JSON, for the viewer and for programs.
#pragma once

#include <string>

#include "sim/debug/answers.h"
#include "sim/report/game_report.h"

namespace sim::report {

/// Returns the decision with its whole tree. Numbers are in SI; those that a robot does not know are null.
///
///   "robot", "skill", "role", "strategy", "sentence"  texts
///   "plays"  whether the tree was asked; otherwise all below is empty
///   "parts"  the tree, each part behind the one in which it lies: {"path", "name", "depth", "skill", "taken"}; the skill of
///            a leaf only
///   "comparisons"  all of them, in the order of the tree: {"node", "part", "condition", "result", "value", "threshold"}.
///                  "part" is the index of the part to which it leads. Texts carry the unit: "0.35 m".
///                  "threshold" and "margin" are null unless the feature is a number
///   "path"  those on the path, in the order in which they were asked: {"node", "feature", "value", "truth", "misled",
///           "threshold", "margin", "flip", "other", "sources"}. "misled": the true value gives the other answer. "flip" is the nearest value that answers otherwise, "other" the skill and leaf
///           that it leads to, "sources" the beliefs behind the value: {"text", "age", "error"}
///   "narrowest"  index in "path" of the comparison with the least margin, or null
///
/// With `has_truth` false, `why` was made without the truth, and "truth" and "error" are null.
Json to_json(const debug::Why& why, const agent::Tree& tree, const std::string& name, bool has_truth = true);

/// Returns the answer to "why not?" of the skill or part `what`.
///
///   "kind"  "reached", "changed", "unreachable" or "unsure"; "leaf" is the path of the reached leaf or null
///   "features"  [{"name", "before", "after", "text"}]; "text" is a bound: "at most 0.35 m"
///   "thresholds"  null or [{"node", "condition", "before", "after"}], texts with units
///   "beliefs"  null or {"changes": [texts], "leaf"}
///   "text"  all of it as text
Json to_json(const debug::Alternative& answer, const agent::Tree& tree, const std::string& name,
             const std::string& what);

}  // namespace sim::report
