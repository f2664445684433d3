#include "sim/debug/why.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/agent/trace.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::for_each_decision;

/// Returns the leaf of a tree for given values, without the evaluation that is tested. Sets `answers` by node.
std::uint16_t walk(const agent::Tree& tree, const Values& values, std::vector<int>& answers) {
  answers.assign(tree.nodes.size(), -1);
  std::uint16_t at = tree.root;
  while (!(at & agent::kLeafBit)) {
    const agent::Node& node = tree.nodes[at];
    const float value = values[static_cast<std::size_t>(node.feature)];
    const float limit = node.other == agent::kNoFeature ? node.threshold : values[static_cast<std::size_t>(node.other)];
    const bool result = holds(node.comparison, value, limit);
    answers[at] = result;
    at = result ? node.yes : node.no;
  }
  return static_cast<std::uint16_t>(at & ~agent::kLeafBit);
}

TEST(Why, FlippingTheReportedComparisonGivesThePromisedOtherBranchIn10000Decisions) {
  int decisions = 0, thresholds = 0, values_flipped = 0;
  for_each_decision(
      10'000, 5,
      [&](const Params& params, const State& state, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        if (testing::Test::HasFailure()) return;
        ++decisions;
        const agent::Tree& tree = behaviour.tree();
        const Thought thought(params, tree, decision);
        const Values values = values_of(tree, thought.view());
        // every comparison of a few decisions, one of the others: edited trees cost more than decisions
        const Why reasons = why(params, behaviour, decision, state);
        ASSERT_FALSE(reasons.path.empty());
        const std::size_t only = static_cast<std::size_t>(decisions) % reasons.path.size();
        for (std::size_t i = 0; i < reasons.path.size(); ++i) {
          const Reason& reason = reasons.path[i];
          const agent::Node& node = tree.nodes[reason.node];
          if (decisions % 20 != 0 && i != only) continue;
          if (!std::isnan(reason.flip.threshold)) {
            // the robot decides again, with the changed tree
            ++thresholds;
            const agent::TreeBehaviour changed(with_threshold(tree, reason.node, reason.flip.threshold));
            agent::Trace trace;
            const Outcome outcome = decide(params, changed, decision, &trace);
            EXPECT_EQ(outcome.mind.leaf, reason.by_threshold) << tree.node_words[reason.node].condition;
            ASSERT_GT(trace.visited.size(), i);
            EXPECT_NE(trace.visited[i].result, reason.answer.result);
            EXPECT_EQ(reason.branch, reason.answer.result ? node.no : node.yes);
          }
          if (!std::isnan(reason.flip.value)) {
            ++values_flipped;
            Values changed = values;
            float& value = changed[static_cast<std::size_t>(node.feature)];
            value = reason.flip.value;
            // the margin is a difference of floats, rounded
            if (!std::isnan(reason.margin)) {
              const float size = std::abs(reason.answer.value) + std::abs(reason.flip.value);
              EXPECT_NEAR(reason.answer.value + reason.margin, reason.flip.value, 1e-6f * (1 + size));
            }
            EXPECT_NE(answer_of(node, changed).result, reason.answer.result);
            std::vector<int> answers;
            EXPECT_EQ(walk(tree, changed, answers), reason.by_value);
          }
        }
      });
  EXPECT_EQ(decisions, 10'000);
  EXPECT_GT(thresholds, 3000);
  EXPECT_GT(values_flipped, 8000);
}

TEST(Why, TellsSkillLeafAndPathOfTheDecision) {
  for_each_decision(
      500, 17,
      [&](const Params& params, const State& state, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        agent::Trace trace;
        const Outcome outcome = decide(params, behaviour, decision, &trace);
        const Why reasons = why(params, behaviour, decision, state);
        EXPECT_EQ(reasons.skill, trace.skill);
        EXPECT_EQ(reasons.role, trace.role);
        EXPECT_EQ(reasons.leaf, outcome.mind.leaf);
        ASSERT_EQ(reasons.path.size() + 1, trace.visited.size());
        for (std::size_t i = 0; i < reasons.path.size(); ++i)
          EXPECT_EQ(behaviour.tree().node_words[reasons.path[i].node].path, trace.visited[i].path);
        if (reasons.narrowest) {
          const std::uint16_t other = reasons.path[*reasons.narrowest].by_value;
          EXPECT_NE(behaviour.tree().leaf_words[other].name, reasons.skill);
        }
        const std::string text = text_of(reasons, behaviour.tree(), "14/3");
        EXPECT_TRUE(text.starts_with("14/3 plays " + reasons.skill + " because ")) << text;
        EXPECT_EQ(std::ranges::count(sentence_of(reasons, behaviour.tree(), "14/3"), '\n'), 0);
      });
}

TEST(Why, OutsidePlayTheReasonIsTheGame) {
  const SharedSetup setup = test::setup_of("baseline", "baseline");
  Timeline timeline = test::timeline_of(setup, 1);
  const auto decision = decision_before(timeline, 30, 1);
  ASSERT_TRUE(decision);
  const State state = timeline.at(decision->tick);
  const Why reasons = why(setup->params, *tree_of(setup->params, 1), *decision, state);
  EXPECT_FALSE(reasons.plays);
  EXPECT_TRUE(reasons.path.empty());
  EXPECT_EQ(text_of(reasons, tree_of(setup->params, 1)->tree(), "home/2"),
            "home/2 plays get_ready because the ball is not in play.\n");
}

TEST(Why, ValuesAreToldInTheirUnits) {
  const auto named = agent::find_feature;
  EXPECT_EQ(value_text(named("ball_distance"), 0.35f), "0.35 m");
  EXPECT_EQ(value_text(named("ball_bearing"), 3.14159274f / 9), "20 deg");
  EXPECT_EQ(value_text(named("ball_known"), 1), "yes");
  EXPECT_EQ(value_text(named("role"), 1), "chaser");
  EXPECT_EQ(value_text(named("pass_gain"), std::nanf("")), "unknown");
}

}  // namespace
}  // namespace sim::debug
