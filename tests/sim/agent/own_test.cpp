#include "sim/agent/own.h"

#include <gtest/gtest.h>

#include "sim/agent/mixed.h"
#include "sim/agent/trace.h"
#include "tests/sim/agent/scene.h"

namespace sim::agent {
namespace {

// the two examples in sim/agent/own: one file each, and a name in a list
TEST(Own, SkillsAndFeaturesFollowOurs) {
  EXPECT_GE(static_cast<int>(find_skill("shadow")), built_in_skill_count());
  EXPECT_GE(static_cast<int>(find_feature("mates_ahead")), built_in_feature_count());
  EXPECT_LE(feature_count(), kMaxFeatures);
}

TEST(Own, ATreeUsesThemLikeOurs) {
  const TreeBehaviour behaviour(tree_of(R"({
    "name": "mine",
    "tree": [
      { "if": "mates_ahead > 0.5", "do": "shadow", "with": { "distance": "2 m" } },
      { "do": "stand" }
    ]
  })"));
  Scene scene;
  scene.see_ball({1, 0});
  EXPECT_EQ(scene.decide(behaviour).body, motion::Command::Body::stand);
  scene.hear(3, {2.5f, 0}, 5, Role::supporter);
  Trace trace;
  const motion::Command command = scene.decide(behaviour, &trace);
  EXPECT_STREQ(trace.skill, "shadow");
  EXPECT_STREQ(trace.visited.front().feature, "mates_ahead");
  EXPECT_EQ(trace.visited.front().value, 1);
  // 2 m behind the ball on the way to the own goal
  EXPECT_EQ(command.body, motion::Command::Body::walk_to);
  EXPECT_NEAR(command.walk.x, -1, 1e-5);
  EXPECT_NEAR(command.walk.y, 0, 1e-5);
}

TEST(Mixed, TheFirstPlayersPlayOneBehaviourAndTheOthersAnother) {
  const TreeBehaviour first(tree_of(R"({"name": "first", "tree": {"do": "look_round"}})"));
  const TreeBehaviour rest(tree_of(R"({"name": "rest", "tree": {"do": "search_ball"}})"));
  const Mixed mixed(first, 2, rest);
  EXPECT_EQ(mixed.name(), "first of 1 .. 2");
  for (std::uint8_t player = 1; player <= 4; ++player) {
    Scene scene;
    scene.game.player = player;
    Trace trace;
    scene.decide(mixed, &trace);
    EXPECT_STREQ(trace.skill, player <= 2 ? "look_round" : "search_ball");
  }
}

}  // namespace
}  // namespace sim::agent
