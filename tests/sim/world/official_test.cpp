#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/world/arena.h"

namespace {

using namespace sim;
using namespace sim::arena;

/// A ball that moves about, and the referee that follows it.
template <class See>
void follow(std::uint64_t seed, See&& see) {
  World world = empty();
  world.key = {seed};
  for (world.tick = 0; world.tick < 900; ++world.tick) {
    const float time = static_cast<float>(world.tick) * kTickDuration;
    world.ball.position = {4 * sim::sin(0.2f * time), 2.5f * sim::sin(0.3f * time)};
    walk_official(kField, world);
    see(world);
  }
}

TEST(Official, WalksAtMostOneMetreASecondAsItsVelocitySays) {
  Vec2 before;
  follow(1, [&](const World& world) {
    if (world.tick > 0) {
      EXPECT_LE(distance(before, world.official.position), kTickDuration * 1.0001f);
      EXPECT_NEAR(distance(before + kTickDuration * world.official.velocity, world.official.position), 0, 1e-5);
    }
    before = world.official.position;
  });
}

TEST(Official, KeepsOneAndAHalfMetresFromTheBall) {
  follow(2, [](const World& world) {
    if (world.tick > 300) {
      EXPECT_NEAR(distance(world.official.position, world.ball.position), 1.5f, 0.1f);
    }
  });
}

TEST(Official, StandsStillAtTheRightDistance) {
  World world = empty();
  for (world.tick = 0; world.tick < 300; ++world.tick) walk_official(kField, world);
  EXPECT_NEAR(length(world.official.velocity), 0, 1e-4);
}

TEST(Official, StartsOnTheLongAxisInARandomHalf) {
  int right = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    World world = empty();
    world.key = {seed};
    walk_official(kField, world);
    EXPECT_EQ(world.official.position.y, 0);
    right += world.official.position.x > 0;
  }
  EXPECT_GT(right, 70);
  EXPECT_LT(right, 130);
}

TEST(Official, AMirroredRefereeWalksTheMirroredWay) {
  follow(3, [](const World& world) {
    World here = world, there = mirrored(world);
    walk_official(kField, here);
    walk_official(kField, there);
    EXPECT_EQ(there.official.position, mirrored(here.official.position));
    EXPECT_EQ(there.official.velocity, mirrored(here.official.velocity));
  });
}

}  // namespace
