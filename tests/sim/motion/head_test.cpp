// Tests of the head.
#include "sim/motion/aim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/motion/arena.h"
#include "tests/sim/motion/dice.h"

namespace sim::motion {
namespace {

Command angles(float yaw, float pitch) {
  Command command;
  command.head = Command::Head::angles;
  command.look[0] = yaw;
  command.look[1] = pitch;
  return command;
}

Command look_to(float x, float y, float z) {
  Command command;
  command.head = Command::Head::look_to;
  command.look[0] = x, command.look[1] = y, command.look[2] = z;
  return command;
}

TEST(Head, StaysWithinItsLimitsAndSpeedAndOffTheShoulders) {
  Dice dice{std::mt19937(1)};
  Arena arena;
  const Head& head = arena.model.head;
  float widest = 0, deepest = 0;
  for (int command = 0; command < 3000; ++command) {
    const float yaw = dice.between(-3, 3);
    const Command order = angles(yaw, dice.between(-1.2f, 1.2f));
    const Tick steps = command % 5 == 0 ? 4 : 1;
    for (int tick = 0; tick < 8; ++tick) {
      const Body before = arena.body();
      arena.move(order, steps);
      const Body& now = arena.body();
      const float dt = static_cast<float>(steps) / 30;
      ASSERT_LE(std::abs(now.head_yaw - before.head_yaw), head.yaw_speed * dt + 1e-6f);
      ASSERT_LE(std::abs(now.head_pitch - before.head_pitch), head.pitch_speed * dt + 1e-6f);
      ASSERT_LE(std::abs(now.head_yaw), yaw_limit_at(head, now.head_pitch));
      ASSERT_GE(now.head_pitch, head.pitch_up);
      ASSERT_LE(now.head_pitch, head.pitch_down);
      ASSERT_NEAR(distance(now.look, direction(now.head_yaw)), 0, 2e-6f);
      widest = std::max(widest, std::abs(now.head_yaw));
      deepest = std::max(deepest, now.head_pitch);
    }
  }
  EXPECT_EQ(widest, head.yaw_limit);
  EXPECT_EQ(deepest, head.pitch_down);
}

TEST(Head, TheShouldersLimitTheYawByThePitch) {
  const Head head = match_model().head;
  const struct {
    float pitch;
    float limit;
  } table[] = {{0, 2},     {0.2f, 2},      {0.21f, 1},    {0.3f, 1},      {0.31f, 0.4f}, {0.5f, 0.4f},
               {-0.4f, 2}, {-0.41f, 0.7f}, {-0.5f, 0.7f}, {-0.51f, 0.3f}, {-0.6f, 0.3f}, {-0.61f, 0.2f}};
  for (const auto& [pitch, limit] : table) EXPECT_EQ(yaw_limit_at(head, pitch), limit) << pitch;
}

TEST(Head, ThePitchGivesWayToTheYaw) {
  const Head head = match_model().head;
  const struct {
    float yaw;
    float up;
    float down;
  } table[] = {{0, head.pitch_up, head.pitch_down},
               {0.35f, -0.5f, head.pitch_down},
               {0.6f, -0.5f, 0.3f},
               {0.9f, -0.4f, 0.3f},
               {1.8f, -0.4f, 0.2f},
               {9, -0.4f, 0.2f}};
  for (const auto& [yaw, up, down] : table) {
    for (const float side : {-1.f, 1.f}) {
      for (const float pitch : {-1.f, 1.f}) {
        Arena arena;
        arena.move(angles(0, pitch), 60);
        for (int tick = 0; tick < 120; ++tick) arena.move(angles(side * yaw, pitch));
        EXPECT_EQ(arena.body().head_yaw, side * std::min(yaw, head.yaw_limit));
        EXPECT_EQ(arena.body().head_pitch, pitch < 0 ? up : down);
      }
    }
  }
}

TEST(Head, MovesAtItsSpeed) {
  Arena arena;
  arena.move(angles(2, -0.3f));
  EXPECT_FLOAT_EQ(arena.body().head_yaw, arena.model.head.yaw_speed / 30);
  EXPECT_FLOAT_EQ(arena.body().head_pitch, -arena.model.head.pitch_speed / 30);
}

TEST(Head, WithoutLimitsItLooksAnywhereAtOnce) {
  Arena arena{.effects = Effects{}};
  arena.move(angles(-3, 0.9f));
  EXPECT_EQ(arena.body().head_yaw, -3);
  EXPECT_EQ(arena.body().head_pitch, 0.9f);
  EXPECT_EQ(arena.body().look, direction(-3));
}

TEST(Head, LooksToAPointInTheMiddleOfTheView) {
  Dice dice{std::mt19937(2)};
  Arena arena{.effects = Effects{}};
  for (int i = 0; i < 1000; ++i) {
    const Vec2 point{dice.between(-3, 3), dice.between(-3, 3)};
    const float height = dice.between(0, 0.8f);
    arena.move(look_to(point.x, point.y, height));
    // the ray 0.44 rad below the head's axis leads from the camera through the point
    const float below = arena.body().head_pitch + 0.44f;
    EXPECT_NEAR(below, atan2(0.45f - height, length(point)), 0.02f);
    EXPECT_NEAR(cross(arena.body().look, point), 0, 0.0201f * length(point));
    EXPECT_GT(dot(arena.body().look, point), 0);
  }
}

TEST(Head, FollowsAMovingPointForLongWithoutDrift) {
  Arena arena;
  for (int tick = 0; tick < 18000; ++tick) {
    const float time = static_cast<float>(tick) / 30;
    arena.move(tick % 900 < 600 ? look_to(1, 1 + sin(time), 0) : angles(1.3f * sin(time), 0.1f));
    ASSERT_NEAR(distance(arena.body().look, direction(arena.body().head_yaw)), 0, 1e-5f) << tick;
  }
}

TEST(Head, StaysStillWithoutACommand) {
  Arena arena;
  arena.move(angles(0.5f, 0.1f), 30);
  const Body before = arena.body();
  arena.move({}, 30);
  EXPECT_EQ(arena.body().head_yaw, before.head_yaw);
  EXPECT_EQ(arena.body().head_pitch, before.head_pitch);
}

TEST(Head, AMirroredLookIsTheMirrorImageToTheBit) {
  Dice dice{std::mt19937(3)};
  Arena left;
  Arena right;
  for (int i = 0; i < 1000; ++i) {
    const float x = dice.between(-2, 2);
    const float y = dice.between(-2, 2);
    left.move(look_to(x, y, 0));
    right.move(look_to(x, -y, 0));
    ASSERT_EQ(left.body().head_yaw, -right.body().head_yaw);
    ASSERT_EQ(left.body().head_pitch, right.body().head_pitch);
    ASSERT_EQ(left.body().look, (Vec2{right.body().look.x, -right.body().look.y}));
  }
}

}  // namespace
}  // namespace sim::motion
