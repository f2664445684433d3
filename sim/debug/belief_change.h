// Why not that leaf? A change of the robot's beliefs that leads there.
//
// All features are computed anew from the changed beliefs, so they stay consistent with each other. The search is by
// samples: it proves a change by doing it, but it cannot prove that there is none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/debug/decision.h"
#include "sim/debug/tree_change.h"

namespace sim::debug {

/// A decision with other beliefs.
struct BeliefChange {
  Decision decision;                 // with the changed beliefs; the tree decides for the goal
  std::vector<std::string> changes;  // one text for each changed belief: "ball 0.31 m nearer to …"
  float size = 0;                    // sum over all changed numbers: [m], [m/s], [s], thirds of a radian
  std::uint16_t leaf = 0;            // number of the reached leaf
};

/// Searches for a change of one belief, then of two. A belief is: place, speed or age of the ball, the own pose, one
/// teammate, one opponent, how soon an opponent may kick, or the own role. Of the changes found it returns one with the
/// fewest beliefs, shrunk until it is small. The same arguments give the same change.
std::optional<BeliefChange> nearest_beliefs(const Params& params, const agent::Tree& tree, const Decision& decision,
                                            const Goal& goal);

}  // namespace sim::debug
