// Small random trees and values, for comparisons with an exhaustive search.
#pragma once

#include <random>

#include "sim/debug/evaluation.h"

namespace sim::debug::test {

/// Makes a tree of 1 to `most` comparisons of few features, so that contradictions are frequent.
agent::Tree random_tree(std::mt19937& random, unsigned most);

/// Makes possible values for the tree: in the range of their features, without a ball often unknown.
Values any_values(std::mt19937& random, const agent::Tree& tree);

/// The features of random_tree.
inline constexpr const char* kFeatures[] = {"ball_known",   "ball_distance",   "ball_x",      "role",
                                            "our_kick",     "opponents_known", "pass_gain",   "mates_time_to_ball",
                                            "time_to_ball", "field_length",    "ball_visible"};

}  // namespace sim::debug::test
