#include "sim/agent/policy.h"

#include <gtest/gtest.h>

#include "sim/agent/trace.h"
#include "sim/io/policy.h"
#include "tests/sim/agent/scene.h"

namespace sim::agent {
namespace {

/// Plays `kick` where the ball is nearer than 1 m, otherwise the rule of `baseline` for the own role.
constexpr const char* kNear = R"({
  "name": "near", "based_on": "baseline",
  "menu": [ { "do": "kick", "with": { "aim": "goal" } },
            [ { "if": "role is keeper", "use": "keeper" }, { "use": "chaser" } ] ],
  "inputs": ["ball_distance"],
  "net": { "layers": [ { "weights": [[-1], [1]], "bias": [0.5, -0.5] } ] }
})";

/// Returns a row of zeros as JSON.
std::string numbers(int count) {
  std::string row = "[0";
  for (int i = 1; i < count; ++i) row += ",0";
  return row + "]";
}

PolicyBehaviour near_policy() {
  auto policy = io::parse_policy(kNear, "strategy 'near'");
  EXPECT_TRUE(policy) << policy.error();
  return *std::move(policy);
}

const char* skill_at(const PolicyBehaviour& policy, float ball_ahead) {
  Scene scene;
  scene.see_ball({ball_ahead, 0});
  static Trace trace;
  scene.decide(policy, &trace);
  return trace.skill;
}

TEST(Policy, PlaysTheRuleOfTheLargestOutput) {
  const PolicyBehaviour policy = near_policy();
  const TreeBehaviour kick(
      tree_of(R"({"name": "k", "based_on": "baseline", "tree": {"do": "kick", "with": {"aim": "goal"}}})"));
  for (const float ahead : {0.3f, 0.6f, 0.9f}) {
    Scene scene, same;
    scene.see_ball({ahead, 0.1f}), same.see_ball({ahead, 0.1f});
    EXPECT_TRUE(scene.decide(policy) == same.decide(kick)) << ahead;
  }
  EXPECT_STREQ(skill_at(policy, 0.8f), "kick");
}

TEST(Policy, ARuleOfTheMenuMayHaveConditions) {
  const PolicyBehaviour policy = near_policy();
  Scene scene;
  scene.see_ball({2.5f, 0});
  scene.game.player = 1;
  Trace trace;
  scene.decide(policy, &trace);
  EXPECT_STREQ(trace.role, "keeper");
  EXPECT_STREQ(trace.strategy, "near");
  EXPECT_STREQ(trace.skill, "keep_goal");
}

TEST(Policy, WhoseOnlyRuleIsAWholeTreeDecidesAsThatTree) {
  const auto policy = io::parse_policy(
      R"({"name": "baseline", "based_on": "baseline", "menu": [[
        {"if": "not ball_known", "do": "search_ball"}, {"if": "role is keeper", "use": "keeper"},
        {"if": "role is chaser", "use": "chaser"}, {"if": "role is defender", "use": "defender"},
        {"use": "supporter"}]], "net": {"layers": [{"weights": [)" +
          numbers(Columns(built_in_features()).count()) + R"(], "bias": [0]}]}})",
      "strategy");
  ASSERT_TRUE(policy) << policy.error();
  const TreeBehaviour tree(shipped("baseline"));
  std::mt19937 random(6);
  for (int i = 0; i < 3000; ++i) {
    Scene scene = random_scene(random), same = scene;
    ASSERT_TRUE(scene.decide(*policy) == same.decide(tree)) << i;
    ASSERT_EQ(scene.mind.role, same.mind.role);
    ASSERT_EQ(scene.mind.kick_direction, same.mind.kick_direction);
  }
}

TEST(Policy, OutsidePlayTheRobotWaitsLikeThatOfATree) {
  const PolicyBehaviour policy = near_policy();
  const TreeBehaviour tree(shipped("baseline"));
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    Scene scene = random_scene(random);
    scene.game.phase = i % 2 ? Game::Phase::ready : Game::Phase::set;
    scene.settings = tree.tree().settings;
    Scene same = scene;
    ASSERT_TRUE(scene.decide(policy) == same.decide(tree));
  }
}

}  // namespace
}  // namespace sim::agent
