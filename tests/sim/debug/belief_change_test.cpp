#include "sim/debug/belief_change.h"

#include <gtest/gtest.h>

#include "sim/debug/why_not.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

TEST(BeliefChange, DecidedAgainReachesTheGoal) {
  int found = 0, asked = 0;
  test::for_each_decision(
      60, 499,
      [&](const Params& params, const State&, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        const agent::Tree& tree = behaviour.tree();
        const std::uint16_t now = decide(params, behaviour, decision).mind.leaf;
        Goal goal(tree.leaves.size());
        for (std::size_t i = 0; i < goal.size(); ++i)
          goal[i] = tree.leaves[i].skill != tree.leaves[now].skill && info_of(tree.leaves[i].skill).name[0] != 's';
        ++asked;
        const auto change = nearest_beliefs(params, tree, decision, goal);
        if (!change) return;
        ++found;
        EXPECT_GE(change->changes.size(), 1u);
        EXPECT_LE(change->changes.size(), 2u);
        EXPECT_GT(change->size, 0);
        const Outcome outcome = decide(params, behaviour, change->decision);
        EXPECT_TRUE(goal[outcome.mind.leaf]) << change->changes[0];
        EXPECT_EQ(outcome.mind.leaf, change->leaf);
        // the same question has the same answer
        const auto again = nearest_beliefs(params, tree, decision, goal);
        ASSERT_TRUE(again);
        EXPECT_EQ(again->changes, change->changes);
      });
  EXPECT_EQ(asked, 60);
  EXPECT_GT(found, 50);
}

TEST(BeliefChange, IsNotFoundForAnUnreachableLeaf) {
  test::for_each_decision(
      1, 50, [&](const Params& params, const State&, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        const Goal nothing(behaviour.tree().leaves.size());
        EXPECT_FALSE(nearest_beliefs(params, behaviour.tree(), decision, nothing));
      });
}

}  // namespace
}  // namespace sim::debug
