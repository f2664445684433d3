// A leaf of a tree with another value of an argument.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/agent/tree.h"

namespace sim::debug {

/// Returns the tree in which the leaves of `where` have another value of `argument`. `where` is a skill, a path or a name,
/// as in goal_of. The value is written as in a strategy: "0.35 m", "goal". Of alternatives the other ones are no longer
/// given. Returns an Error if none of these leaves takes the argument, or for a value out of its range.
robot::Result<agent::Tree> with_argument(agent::Tree tree, const std::string& where, std::string_view argument,
                                         std::string_view value);

/// The name and the value of an argument that a leaf is given: "tolerance", "15 deg".
struct Argument {
  std::string name, value;
};

/// Returns the arguments of a leaf, by its number.
std::vector<Argument> arguments_of(const agent::Tree& tree, std::size_t leaf);

/// Returns a line for each leaf, in the order of the tree: its path, and the arguments that are given.
std::string leaves_text(const agent::Tree& tree);

}  // namespace sim::debug
