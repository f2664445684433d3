// Why not that leaf? The smallest change of thresholds that leads there.
#pragma once

#include <optional>
#include <vector>

#include "sim/debug/flip.h"

namespace sim::debug {

/// A set of leaves, by number.
using Goal = std::vector<bool>;

/// A threshold that is changed.
struct NewThreshold {
  std::uint16_t node = 0;
  float before = 0;  // [SI]
  float after = 0;
};

/// Returns the fewest new thresholds with which the tree reaches a leaf of the goal. Of equally few it returns those with
/// the smallest sum of changes, by scale_of. Nothing: no thresholds lead there.
///
/// Each comparison has a threshold of its own, so one change affects no other comparison. The search over the tree is
/// complete.
std::optional<std::vector<NewThreshold>> nearest_thresholds(const agent::Tree& tree, const Values& values,
                                                            const Goal& goal);

/// Returns the tree with these thresholds.
agent::Tree with_thresholds(agent::Tree tree, const std::vector<NewThreshold>& changes);

}  // namespace sim::debug
