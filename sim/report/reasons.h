// The reasons of a decision as JSON, for the viewer and for programs.
#pragma once

#include <string>

#include "sim/debug/answers.h"
#include "sim/report/game_report.h"

namespace sim::report {

/// Returns the decision with its whole tree. Numbers are in SI, and texts of values carry their unit: "0.35 m". Unknown is
/// null. With `has_truth` false, `why` was made without the truth, and "truth" and "error" are null.
///
///   "robot", "skill", "role", "strategy", "sentence": texts.
///
///   "plays": whether the tree was asked. Otherwise the lists are empty.
///
///   "parts": the tree, each part behind the one in which it lies.
///   {"path", "name", "depth", "skill", "taken"}; only a leaf has a skill.
///
///   "comparisons": all of them, in the order of the tree.
///   {"node", "part", "condition", "result", "value", "threshold"}; "part" is the index of the part to which it leads.
///
///   "path": the comparisons that were asked, in this order.
///   {"node", "feature", "value", "truth", "misled", "threshold", "margin", "flip", "other", "sources"}.
///   "misled": the true value gives the other answer. "flip" is the nearest value that answers otherwise, and "other" the
///   {"skill", "leaf"} that it leads to. "sources" are the beliefs behind the value: {"text", "age", "error"}.
///   "threshold" and "margin" are null unless the feature is a number.
///
///   "narrowest": the index in "path" of the comparison with the least margin.
Json to_json(const debug::Why& why, const agent::Tree& tree, const std::string& name, bool has_truth = true);

/// Returns the answer to "why not?" of the skill or part `what`. Null stands for a part that was not found.
///
///   "kind": "reached", "changed", "unreachable" or "unsure".
///
///   "leaf": the path of the reached leaf.
///
///   "features": [{"name", "before", "after", "text"}]; "text" is a bound: "at most 0.35 m".
///
///   "thresholds": [{"node", "condition", "before", "after"}].
///
///   "beliefs": {"changes", "leaf"}; the changes are texts.
///
///   "text": all of it as text.
Json to_json(const debug::Alternative& answer, const agent::Tree& tree, const std::string& name,
             const std::string& what);

}  // namespace sim::report
