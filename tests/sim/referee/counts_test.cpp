#include <gtest/gtest.h>

#include "tests/sim/referee/scene.h"

namespace sim::referee {
namespace {

TEST(GameCounts, CountsKicksWhiffsAndPossessionInPlay) {
  Scene scene(rules_2012());
  scene.start_play();
  scene.counts = {};
  scene.world.kicked = static_cast<std::uint8_t>(robot_of(Side::away, 2));
  scene.touch(Side::away, 2);
  scene.pass(9);
  scene.world.whiffed = 1;
  scene.pass();
  scene.touch(Side::home, 3);
  scene.pass(4);
  EXPECT_EQ(scene.counts.kicks[0], 0);
  EXPECT_EQ(scene.counts.kicks[1], 1);
  EXPECT_EQ(scene.counts.whiffs[0], 1);
  EXPECT_EQ(scene.counts.possession[0], 5u);
  EXPECT_EQ(scene.counts.possession[1], 11u);
  EXPECT_EQ(scene.counts.in_play, 16u);
}

TEST(GameCounts, AShotIsAKickWhoseBallWouldRollIntoTheGoal) {
  struct Case {
    Side side;
    Vec2 from, velocity;
    bool shot;
  };
  const Case cases[] = {
      {Side::home, {1, 0}, {1.3f, 0}, true},       // rolls 2.8 m
      {Side::home, {1, 0}, {1.1f, 0}, false},      // rolls 2.0 m
      {Side::home, {1, 0}, {1.3f, 0.4f}, true},    // crosses 0.64 m beside the middle
      {Side::home, {1, 0}, {1.3f, -0.5f}, false},  // crosses 0.80 m beside it
      {Side::home, {-1, 0}, {-1.3f, 0}, false},    // at the own goal
      {Side::away, {-1, 0}, {-1.3f, 0}, true},    {Side::away, {-1, 1.5f}, {-1.4f, -0.7f}, true},
  };
  for (const Case& at : cases) {
    Scene scene(rules_2012());
    scene.start_play();
    scene.ball().position = at.from;
    scene.ball().velocity = at.velocity;
    scene.world.kicked = static_cast<std::uint8_t>(robot_of(at.side, 2));
    scene.touch(at.side, 2);
    EXPECT_EQ(scene.counts.shots[static_cast<int>(at.side)], at.shot) << at.velocity.x << " " << at.velocity.y;
    EXPECT_EQ(scene.counts.shots[static_cast<int>(other(at.side))], 0);
  }
}

}  // namespace
}  // namespace sim::referee
