// The game that is debugged: parameters, and the decision trees to which they point.
#pragma once

#include <memory>
#include <vector>

#include "robot/core/result.h"
#include "sim/agent/tree.h"
#include "sim/contest/lineup.h"
#include "sim/io/matchup.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::debug {

/// The parameters of a game, with the behaviours to which they point. Immutable and shared.
struct Setup {
  Params params;
  std::vector<std::shared_ptr<const agent::Behaviour>> behaviours;
};
using SharedSetup = std::shared_ptr<const Setup>;

/// Prepares a game of decision trees. Refuses behaviours from outside and playbooks: they have no comparisons, and they
/// keep a memory that no State holds.
robot::Result<SharedSetup> prepare(const contest::LineupChoice& choice);

/// Prepares the rest of a game that is already played. A side that follows its captain keeps the strategy of `state`.
/// Refuses what prepare() refuses.
robot::Result<SharedSetup> rest_of_game(const io::PreparedGame& game, const State& state);

/// Returns the tree that a robot plays, or nullptr if its behaviour is not a tree.
const agent::TreeBehaviour* tree_of(const Params& params, int robot);

/// Returns the same game with another tree for the players of this robot's side that play its tree now.
SharedSetup with_tree(const SharedSetup& setup, int robot, agent::Tree tree);

}  // namespace sim::debug
