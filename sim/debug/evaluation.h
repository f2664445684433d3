// A whole tree, evaluated for one decision: every comparison, also those beside the path.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/agent/tree.h"

namespace sim::debug {

/// The values of all features by number, NaN where the robot does not know one. Only those that a tree reads are set.
using Values = std::vector<float>;

/// Returns the index of a feature in Values.
constexpr std::size_t index_of(agent::Feature feature) { return static_cast<std::size_t>(feature); }

/// Returns the values of the features that the tree reads, and of ball_known.
Values values_of(const agent::Tree& tree, const agent::View& view);

/// The answer of one comparison.
struct Answer {
  float value = 0;      // [SI] of the feature
  float threshold = 0;  // [SI], or the value of the other feature
  bool result = false;
};

/// Returns the answer of one node.
Answer answer_of(const agent::Node& node, const Values& values);
/// Returns the node or leaf at which the tree goes on.
std::uint16_t next_of(const agent::Node& node, const Values& values);
/// Returns the number of the leaf to which the tree goes from `at`.
std::uint16_t leaf_from(const agent::Tree& tree, std::uint16_t at, const Values& values);
inline std::uint16_t leaf_of(const agent::Tree& tree, const Values& values) {
  return leaf_from(tree, tree.root, values);
}

/// All answers of a tree, and the path that it takes.
struct Evaluation {
  std::vector<Answer> nodes;        // by number
  std::vector<std::uint16_t> path;  // numbers of nodes, from the root
  std::uint16_t leaf = 0;           // number
};
Evaluation evaluate(const agent::Tree& tree, const Values& values);

}  // namespace sim::debug
