// Changes of a strategy's rules.
#pragma once

#include <string>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/io/json.h"
#include "sim/learn/layer.h"

namespace sim::learn {

/// A leaf of a strategy: a rule with "do".
struct LeafRule {
  std::string pointer;                 // JSON pointer
  std::string name;                    // for people
  io::Json action;                     // "do" and "with"
  std::vector<io::Json> alternatives;  // other actions
};

/// Returns the leaves of a layer, each with its marked actions or else those of the layer.
std::vector<LeafRule> leaves_of(const io::Json& strategy, const Layer& layer);

/// Returns the strategy with another action in the rule at `pointer`.
io::Json with_action(io::Json strategy, const std::string& pointer, const io::Json& action);

/// Returns the strategy with the rule "if `condition` do `action`" before the rule at `pointer`, within its condition.
io::Json with_split(io::Json strategy, const std::string& pointer, const std::string& condition,
                    const io::Json& action);

/// A rule that can go: another rule follows it in its list.
struct SpareRule {
  std::string pointer, name;
};
/// Returns the spare leaves of a layer.
std::vector<SpareRule> spare_rules(const io::Json& strategy, const Layer& layer);

/// Returns the strategy without a rule, and without the parameters and subtrees that only this rule used.
io::Json without_rule(io::Json strategy, const std::string& pointer);

/// Returns the strategy without parameters and subtrees that no rule uses.
io::Json without_unused(io::Json strategy);

/// Returns the action in words: "dribble (aim goal, tolerance 30 deg)".
std::string words_of(const io::Json& action);

}  // namespace sim::learn
