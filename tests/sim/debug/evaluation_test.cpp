#include "sim/debug/evaluation.h"

#include <gtest/gtest.h>

#include "sim/agent/trace.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

TEST(Evaluation, TakesThePathOfTheDecision) {
  test::for_each_decision(
      2000, 7,
      [&](const Params& params, const State&, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        const agent::Tree& tree = behaviour.tree();
        const Thought thought(params, tree, decision);
        const Evaluation evaluation = evaluate(tree, values_of(tree, thought.view()));
        EXPECT_EQ(evaluation.leaf, decide(params, behaviour, decision).mind.leaf);
        agent::Trace trace;
        decide(params, behaviour, decision, &trace);
        ASSERT_EQ(evaluation.path.size() + 1, trace.visited.size());
        for (std::size_t i = 0; i < evaluation.path.size(); ++i)
          EXPECT_EQ(tree.node_words[evaluation.path[i]].condition, trace.visited[i].condition);
      });
}

TEST(Evaluation, AnswersEveryComparisonOfTheTree) {
  test::for_each_decision(
      200, 31,
      [&](const Params& params, const State&, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        const agent::Tree& tree = behaviour.tree();
        const Thought thought(params, tree, decision);
        const Evaluation evaluation = evaluate(tree, values_of(tree, thought.view()));
        ASSERT_EQ(evaluation.nodes.size(), tree.nodes.size());
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
          const agent::Node& node = tree.nodes[i];
          const float value = value_of(node.feature, thought.view());
          const float threshold =
              node.other == agent::kNoFeature ? node.threshold : value_of(node.other, thought.view());
          EXPECT_EQ(evaluation.nodes[i].result, holds(node.comparison, value, threshold));
        }
      });
}

}  // namespace
}  // namespace sim::debug
