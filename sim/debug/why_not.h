// Why not that leaf? The smallest set of features that would have to have other values.
//
// Features depend on each other: ball_off_centre is |ball_y|. This search treats them as independent, except for two
// rules. Without a known ball all features of the ball are unknown, at no cost. With a newly known ball each of them
// that the path reads gets a value, and counts as changed. Whether beliefs exist that have these values is answered by
// sim/debug/belief_change.h, which changes beliefs and computes all features anew.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/debug/tree_change.h"

namespace sim::debug {

/// A feature with another value.
struct NewValue {
  agent::Feature feature;
  float before = 0;  // [SI] NaN: unknown
  float after = 0;
};

/// The answer to "why not?".
struct WhyNot {
  enum class Kind {
    reached,      // the decision reaches the goal as it is
    changed,      // `values` lead there
    unreachable,  // no possible values of the features lead there
    unsure,       // the tree has more paths than kMostVisits, and none was found
  };
  Kind kind = Kind::reached;
  // The fewest features; of equally few those with the smallest sum of changes, by scale_of. A change to or from
  // "unknown", and of yes or no and of a name, counts 1.
  std::vector<NewValue> values;
  std::uint16_t leaf = 0;  // number of the leaf that they reach; only for reached and changed
};

inline constexpr std::int64_t kMostVisits = 20'000'000;

/// Finds the smallest change of features that leads to a leaf of the goal. The search is complete: over all paths of the
/// tree, and over all cells between the thresholds of each feature.
///
/// Possible are the values in the range of a feature, whole ones of a feature that counts, and "unknown" where the table
/// of features says so. Fixed features keep their value.
WhyNot why_not(const agent::Tree& tree, const Values& values, const Goal& goal);

/// Returns the values with these changes. Without a known ball, the features of the ball are unknown.
Values with_values(Values values, const std::vector<NewValue>& changes);

/// Returns all values that matter for a feature beside its present one: one in each cell between the thresholds of the
/// tree, and the thresholds themselves.
std::vector<float> candidates_of(const agent::Tree& tree, const Values& values, agent::Feature feature);

}  // namespace sim::debug
