// Tests of robots that meet.
#include <gtest/gtest.h>

#include "tests/sim/world/arena.h"

namespace {

using namespace sim;
using namespace sim::arena;

constexpr int kOne = 2, kAnother = robot_of(Side::away, 3);

/// Parts the robots and returns their collisions; `met` receives what `keep_bodies_apart` reports.
AllCollisions meet(World& world, bool* met = nullptr) {
  Crowd crowd = crowd_of(world);
  const bool any = keep_bodies_apart(kField, kContact, crowd, world);
  if (met) *met = any;
  return collisions_of(kContact, world);
}

/// Two robots that overlap a little, on a line at `angle` [rad]. They walk towards each other with these speeds [m/s].
World two(float angle, float first, float second) {
  World world = empty();
  const Vec2 line = direction(angle);
  walk(world, kOne, {1, 1}, angle, {first, 0});
  walk(world, kAnother, Vec2{1, 1} + 0.315f * line, angle, {-second, 0});
  return world;
}

TEST(Collisions, TwoThatMeetGetTheirClosingSpeedAlongTheirLine) {
  for (float angle = -3; angle < 3; angle += 0.37f) {
    World world = two(angle, 0.2f, 0.1f);
    bool met = false;
    const AllCollisions all = meet(world, &met);
    EXPECT_TRUE(met);
    // both face along the line: one is pushed backwards, the other forwards
    EXPECT_NEAR(all.closing[kOne].x, -0.3f, 1e-4f);
    EXPECT_NEAR(all.closing[kOne].y, 0, 1e-4f);
    EXPECT_NEAR(all.closing[kAnother].x, 0.3f, 1e-4f);
    EXPECT_NEAR(all.closing[kAnother].y, 0, 1e-4f);
  }
}

TEST(Collisions, OnlyTheSpeedAlongTheLineCounts) {
  World world = two(0, 0.2f, 0);
  world.bodies[kOne].velocity = {0.1f, 0.2f};
  const AllCollisions all = meet(world);
  EXPECT_NEAR(all.closing[kOne].x, -0.1f, 1e-4f);
  EXPECT_NEAR(all.closing[kOne].y, 0, 1e-4f);
}

TEST(Collisions, ThoseThatPartOrAreApartHaveNone) {
  World parting = two(0.5f, -0.1f, -0.1f);
  EXPECT_EQ(meet(parting).closing[kOne], Vec2{});

  World apart = two(0.5f, 0.2f, 0.2f);
  apart.bodies[kAnother].position += {1, 0};
  bool met = true;
  EXPECT_EQ(meet(apart, &met).closing[kOne], Vec2{});
  EXPECT_FALSE(met);
}

TEST(Collisions, ATouchThatGoesOnIsNoCollision) {
  World world = two(0, 0.2f, 0.2f);
  bool met = false;
  EXPECT_NE(meet(world, &met).closing[kOne], Vec2{});
  for (int tick = 0; tick < 20; ++tick) {
    for (const int robot : {kOne, kAnother}) {
      Body& body = world.bodies[robot];
      body.position += kTickDuration * turned(body.velocity, body.facing);
    }
    EXPECT_EQ(meet(world, &met).closing[kOne], Vec2{});
    EXPECT_FALSE(met);
  }
}

TEST(Collisions, AThirdOneThatComesCollidesWithARobotThatTouchesAnother) {
  World world = two(0, 0, 0);
  meet(world);
  const int third = 4;
  walk(world, third, {1, 1.315f}, -kPi / 2, {0.2f, 0});
  const AllCollisions all = meet(world);
  EXPECT_NEAR(all.closing[third].x, -0.2f, 0.02f);
  EXPECT_NEAR(all.closing[kOne].y, -0.2f, 0.02f) << "pushed to its right";
  EXPECT_EQ(all.closing[kAnother], Vec2{});
}

TEST(Collisions, ThoseOfOneRobotAddUp) {
  World world = two(0, 0.1f, 0.05f);
  walk(world, 4, {0.685f, 1}, 0, {0.3f, 0});  // from behind, 0.2 m/s faster
  const AllCollisions all = meet(world);
  EXPECT_NEAR(all.closing[kOne].x, 0.2f - 0.15f, 1e-3f);
  EXPECT_NEAR(all.closing[kAnother].x, 0.15f, 1e-3f);
  EXPECT_NEAR(all.closing[4].x, -0.2f, 1e-3f);
}

TEST(Collisions, ARobotBetweenTwoThatComeAlikeIsPushedNowhere) {
  for (const int first : {0, 5}) {
    World world = empty();
    stand(world, kOne, {1, 1});
    walk(world, first, {1, 0.685f}, kPi / 2, {0.2f, 0});
    walk(world, 5 - first, {1, 1.315f}, -kPi / 2, {0.2f, 0});
    EXPECT_NEAR(length(meet(world).closing[kOne]), 0, 1e-5f);
  }
}

TEST(Collisions, ALyingRobotIsRunIntoAtItsOwnSize) {
  World world = two(0, 0.2f, 0);
  Body& lying = world.bodies[kAnother];
  lying.doing = Body::Doing::fallen;
  lying.position = {1 + kContact.robot_radius + kContact.lying_radius, 1};
  EXPECT_NEAR(meet(world).closing[kOne].x, -0.2f, 1e-4f);
}

TEST(Collisions, DoNotDependOnTheOrderOfRobots) {
  std::mt19937 random(5);
  int collisions = 0;
  for (int i = 0; i < 300; ++i) {
    World world = crowd(random, {1, 2}, 1.5f);
    int order[kMaxRobots];
    shuffle(random, order);
    World other = reordered(world, order);
    const AllCollisions all = meet(world), again = meet(other);
    for (int robot = 0; robot < kMaxRobots; ++robot) {
      EXPECT_EQ(again.closing[robot], all.closing[order[robot]]);
      collisions += all.closing[robot] == Vec2{} ? 0 : 1;
    }
  }
  EXPECT_GT(collisions, 100);
}

}  // namespace
