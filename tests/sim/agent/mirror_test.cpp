#include "sim/agent/mirror.h"

#include <gtest/gtest.h>

#include "tests/sim/agent/scene.h"

namespace sim::agent {
namespace {

Scene image_of(Scene scene) {
  scene.beliefs = mirrored(scene.beliefs);
  scene.mind = mirrored(scene.mind);
  return scene;
}

/// Treats -0 and 0 as equal.
void expect_same(const motion::Command& a, const motion::Command& b, int number) {
  EXPECT_TRUE(a == b) << "situation " << number << ": body " << int(a.body) << " " << int(b.body) << ", walk "
                      << a.walk.x << " " << a.walk.y << " / " << b.walk.x << " " << b.walk.y << ", turn " << a.turn
                      << " / " << b.turn << ", head " << int(a.head) << " " << a.look[0] << " " << a.look[1] << " / "
                      << b.look[0] << " " << b.look[1] << ", leg " << a.kick_left << b.kick_left;
}

void expect_mirrored_decisions(const Tree& tree, int situations, bool mirror_the_tree) {
  const TreeBehaviour behaviour(tree);
  const TreeBehaviour other(mirror_the_tree ? mirrored(tree) : tree);
  std::mt19937 random(11);
  for (int i = 0; i < situations; ++i) {
    Scene scene = random_scene(random);
    // going to the places of the kick-off is lateral for every tree
    if (mirror_the_tree && i % 10 == 0) scene.game.phase = Game::Phase::ready;
    Scene image = image_of(scene);
    const motion::Command command = scene.decide(behaviour), image_command = image.decide(other);
    expect_same(mirrored(command), image_command, i);
    const Mind mind = mirrored(scene.mind);
    ASSERT_EQ(mind.leaf, image.mind.leaf) << "situation " << i;
    ASSERT_EQ(mind.role, image.mind.role) << "situation " << i;
    ASSERT_EQ(mind.slot, image.mind.slot) << "situation " << i;
    ASSERT_EQ(mind.search_side, image.mind.search_side) << "situation " << i;
    ASSERT_EQ(mind.kick_direction, image.mind.kick_direction) << "situation " << i;
  }
}

TEST(Mirror, ShippedStrategiesDecideTheMirroredCommandInTheMirroredSituation) {
  for (const char* name : kShipped) {
    SCOPED_TRACE(name);
    expect_mirrored_decisions(shipped(name), 5000, false);
  }
}

constexpr const char* kLateral = R"({
  "name": "lateral",
  "tree": [
    { "if": "ball_bearing > 20 deg or ball_left <= -0.5", "do": "position", "with": { "y": "0.7 m" } },
    { "if": "y >= 0.5 and heading < 1", "do": "look_round" },
    { "if": "lane > 0.2", "do": "block", "with": { "spread": "1 m" } },
    { "if": "crossing_left < 0.1", "do": "keep_goal" },
    { "if": "goal_bearing < -0.3", "do": "dribble" },
    { "if": "ball_left > y or not ball_y >= ball_left", "do": "look_round" },
    { "if": "not ball_distance < ball_off_centre", "do": "walk_to_ball" },
    { "if": "ball_y < 0.2", "do": "kick" },
    { "do": "search_ball" }
  ]
})";

TEST(Mirror, AMirroredTreeDecidesTheMirroredCommandInTheMirroredSituation) {
  expect_mirrored_decisions(tree_of(kLateral), 20000, true);
}

TEST(Mirror, AllSkillsAreMirrored) {
  for (int i = 0; i < skill_count(); ++i) {
    const std::string skill = info_of(static_cast<Skill>(i)).name;
    SCOPED_TRACE(skill);
    expect_mirrored_decisions(tree_of(R"({"name": "one", "tree": {"do": ")" + skill + R"("}})"), 2000, true);
  }
}

TEST(Mirror, KicksOfAllKindsAreMirroredWithTheirTargets) {
  for (const char* with :
       {R"("kick": "any", "range": 1)", R"("kick": "any", "range": 1, "direction": "50 deg")",
        R"("kick": "side", "target": [1, -1.5])", R"("kick": "turn", "tolerance": 1)", R"("target": [2, 0.7])"}) {
    SCOPED_TRACE(with);
    expect_mirrored_decisions(tree_of(std::string(R"({"name": "k", "tree": {"do": "kick", "with": {)") + with + "}}}"),
                              5000, true);
  }
}

TEST(Mirror, PlacesAndDribblesAreMirrored) {
  for (const char* leaf : {R"("do": "go_to", "with": {"point": [1, 0.7]})",
                           R"("do": "go_to", "with": {"point": [-1, 2], "direction": "50 deg"})",
                           R"("do": "dribble", "with": {"past": "nearest", "direction": "-20 deg"})"}) {
    SCOPED_TRACE(leaf);
    expect_mirrored_decisions(tree_of(std::string(R"({"name": "p", "tree": {)") + leaf + "}}"), 5000, true);
  }
}

TEST(Mirror, MirroringTwiceChangesNothing) {
  std::mt19937 random(2);
  const TreeBehaviour behaviour(tree_of(kLateral)), twice(mirrored(mirrored(behaviour.tree())));
  for (int i = 0; i < 1000; ++i) {
    Scene scene = random_scene(random), again = image_of(image_of(scene));
    EXPECT_EQ(scene.decide(behaviour), again.decide(twice));
  }
}

TEST(Mirror, LateralFeaturesAreThoseThatChangeTheirSign) {
  std::mt19937 random(3);
  for (int n = 0; n < 3000; ++n) {
    Scene scene = random_scene(random), image = image_of(scene);
    const View view = scene.view(), image_view = image.view();
    for (int i = 0; i < feature_count(); ++i) {
      const auto feature = static_cast<Feature>(i);
      const float value = value_of(feature, view), image_value = value_of(feature, image_view);
      if (std::isnan(value)) {
        EXPECT_TRUE(std::isnan(image_value)) << info_of(feature).name;
        continue;
      }
      EXPECT_EQ(info_of(feature).lateral ? -value : value, image_value) << info_of(feature).name;
    }
  }
}

}  // namespace
}  // namespace sim::agent
