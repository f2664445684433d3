#include "sim/debug/tree_change.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "tests/sim/debug/played.h"
#include "tests/sim/debug/random_tree.h"

namespace sim::debug {
namespace {

using test::any_values;
using test::random_tree;

/// Returns the fewest thresholds whose flips lead to the goal by trying all sets, or -1.
int fewest(const agent::Tree& tree, const Values& values, const Goal& goal) {
  const auto nodes = static_cast<unsigned>(tree.nodes.size());
  int best = -1;
  for (unsigned set = 0; set < 1u << nodes; ++set) {
    agent::Tree changed = tree;
    bool possible = true;
    for (unsigned i = 0; i < nodes; ++i) {
      if (!(set >> i & 1)) continue;
      const float threshold = flip_of(tree.nodes[i], answer_of(tree.nodes[i], values)).threshold;
      if (std::isnan(threshold)) possible = false;
      changed.nodes[i].threshold = threshold;
    }
    if (possible && goal[leaf_of(changed, values)] && (best < 0 || std::popcount(set) < best))
      best = std::popcount(set);
  }
  return best;
}

TEST(TreeChange, OfSmallTreesIsTheSmallestOfAllSetsOfThresholds) {
  std::mt19937 random(1);
  int none = 0;
  for (int n = 0; n < 3000; ++n) {
    const agent::Tree tree = random_tree(random, 7);
    const Values values = any_values(random, tree);
    Goal goal(tree.leaves.size());
    goal[random() % goal.size()] = true;
    const auto changes = nearest_thresholds(tree, values, goal);
    const int expected = fewest(tree, values, goal);
    ASSERT_EQ(changes ? static_cast<int>(changes->size()) : -1, expected) << n;
    none += !changes;
    if (changes) {
      EXPECT_TRUE(goal[leaf_of(with_thresholds(tree, *changes), values)]);
    }
  }
  EXPECT_GT(none, 10);
}

TEST(TreeChange, AppliedToTheTreeOfARobotReachesTheSkill) {
  int reached = 0;
  std::mt19937 random(2);
  test::for_each_decision(
      1000, 29,
      [&](const Params& params, const State&, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        const agent::Tree& tree = behaviour.tree();
        Goal goal(tree.leaves.size());
        goal[random() % goal.size()] = true;
        const Thought thought(params, tree, decision);
        const auto changes = nearest_thresholds(tree, values_of(tree, thought.view()), goal);
        if (!changes) return;
        ++reached;
        const agent::TreeBehaviour changed(with_thresholds(tree, *changes));
        EXPECT_TRUE(goal[decide(params, changed, decision).mind.leaf]);
      });
  EXPECT_GT(reached, 100);
}

}  // namespace
}  // namespace sim::debug
