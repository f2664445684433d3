// The game that is debugged: parameters, and the decision trees to which they point.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/result.h"
#include "sim/agent/tree.h"
#include "sim/contest/lineup.h"
#include "sim/io/matchup.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::debug {

/// The place of a behaviour from outside (sim/guest) in the parameters. Timeline replaces it by the players of its game.
class Outside final : public agent::Behaviour {
 public:
  explicit Outside(std::string name) : name_(std::move(name)) {}

  const std::string& name() const override { return name_; }
  /// The robot stands.
  motion::Command decide(const agent::Surroundings&, const agent::Game&, const agent::Beliefs&, Tick, agent::Mind&,
                         agent::Trace*) const override {
    return {};
  }

 private:
  const std::string name_;
};

/// The parameters of a game, with the behaviours to which they point. Immutable and shared.
struct Setup {
  Params params;
  std::vector<std::shared_ptr<const agent::Behaviour>> behaviours;
  std::shared_ptr<const contest::Lineup> lineup;  // of behaviours from outside; nullptr: trees play both sides
};
using SharedSetup = std::shared_ptr<const Setup>;

/// Prepares a game of decision trees and behaviours from outside. Refuses playbooks, which keep a memory that no State
/// holds, and a side that mixes a behaviour from outside with another one.
robot::Result<SharedSetup> prepare(const contest::LineupChoice& choice);

/// Returns the Error that names a side without a decision tree.
robot::Result<void> check_trees(const Setup& setup);

/// Prepares the rest of a game that is already played. A side that follows its captain keeps the strategy of `state`.
/// Refuses what prepare() refuses.
robot::Result<SharedSetup> rest_of_game(const io::PreparedGame& game, const State& state);

/// Returns the tree that a robot plays, or nullptr if its behaviour is not a tree.
const agent::TreeBehaviour* tree_of(const Params& params, int robot);

/// Returns the same game with another tree for the players of this robot's side that play its tree now.
SharedSetup with_tree(const SharedSetup& setup, int robot, agent::Tree tree);

}  // namespace sim::debug
