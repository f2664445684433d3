// The nearest change that makes one comparison answer otherwise.
#pragma once

#include "sim/debug/evaluation.h"

namespace sim::debug {

/// Two ways to the other answer of one comparison. NaN: that way does not exist.
struct Flip {
  float value = 0;      // [SI] nearest possible value of the feature that gives the other answer
  float threshold = 0;  // [SI] nearest threshold that gives it, for a comparison with a number
};

/// Returns both ways. A value is possible if it is in the range of its feature, and whole if it counts things. A fixed
/// feature has no other value. A threshold is no way for an unknown value and for a yes-or-no feature.
Flip flip_of(const agent::Node& node, const Answer& answer);

/// Returns the nearest number that passes `comparison` with `threshold`, for a value that does not pass. It may be
/// outside the range of a feature. NaN: none.
float nearest_passing(agent::Comparison comparison, float value, float threshold, bool whole);

/// Returns the size [SI] of a change that is as large as 1 m, to compare changes of features with different units.
float scale_of(const agent::FeatureInfo& info);

/// Returns the tree with another threshold in one node.
agent::Tree with_threshold(agent::Tree tree, std::uint16_t node, float threshold);

}  // namespace sim::debug
