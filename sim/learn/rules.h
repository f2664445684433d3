// The rules of a strategy, by their places.
#pragma once

#include <functional>
#include <string>

#include "sim/io/json.h"

namespace sim::learn {

/// The place of a rule.
struct RulePlace {
  std::string pointer;  // JSON pointer: "/subtrees/shoot/2"
  std::string name;     // for people: "shoot / free"
};

/// Calls see(place, rule) for each rule of "tree" and "subtrees", in the order of the text, outer rules first.
void for_each_rule(const io::Json& strategy, const std::function<void(const RulePlace&, const io::Json&)>& see);

/// Returns the rule's own name: "name", or its condition, or its skill.
std::string name_of_rule(const io::Json& rule);

/// Returns the name of a JSON pointer's token: "~" and "/" are escaped.
std::string pointer_token(const std::string& key);

}  // namespace sim::learn
