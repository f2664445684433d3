// Tests of falls by a table.
#include "sim/motion/fall_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/motion/arena.h"

namespace sim::motion {
namespace {

using Doing = Body::Doing;

constexpr Toppling kToppling{.slope = 6, .half = {2, 2.2f, 2.4f, 2.6f, 3, 2.8f, 2.3f, 2.1f}};

/// Returns a table whose classes differ only in how often their robots fall.
FallTable table_of(float soft) {
  const ServoClass stiff{.rates = {.per_minute = {1, 2, 3, 4, 5, 6}, .shoved_standing = 7, .shoved_walking = 8},
                         .standing = kToppling,
                         .walking = kToppling};
  return {.given = true,
          .collisions = {.mass = 5, .bounce = 0.2f, .soft = soft},
          .stiff = stiff,
          .soft = {.rates = {}, .standing = kToppling, .walking = kToppling}};
}

/// Returns the logarithm of the odds that this push [N s, robot] topples a robot.
float odds(Vec2 impulse) {
  const float probability = kToppling.probability(impulse);
  return std::log(probability / (1 - probability));
}

TEST(Toppling, HalfOfTheRobotsFallByTheImpulseOfEachDirection) {
  for (int i = 0; i < 8; ++i) {
    const float angle = static_cast<float>(i) * kPi / 4;
    EXPECT_NEAR(kToppling.probability(kToppling.half[i] * direction(angle)), 0.5f, 1e-4f) << i;
    const float between = 0.5f * (kToppling.half[i] + kToppling.half[(i + 1) % 8]);
    EXPECT_NEAR(kToppling.probability(between * direction(angle + kPi / 8)), 0.5f, 1e-4f) << i;
  }
}

TEST(Toppling, TheLogarithmOfTheOddsRisesByTheSlope) {
  for (float angle = -3.1f; angle < 3.1f; angle += 0.21f) {
    const Vec2 line = direction(angle);
    EXPECT_NEAR(odds(std::exp(1.f) * line) - odds(line), kToppling.slope, 1e-2f) << angle;
  }
}

TEST(Toppling, IsAProbabilityForEveryPush) {
  EXPECT_LT(kToppling.probability({}), 1e-6f);
  for (float strength = 1e-30f; strength < 1e6f; strength *= 10)
    for (float angle = -kPi; angle <= kPi; angle += kPi / 16) {
      const float probability = kToppling.probability(strength * direction(angle));
      EXPECT_TRUE(probability >= 0 && probability <= 1) << strength << ", " << angle;
    }
}

TEST(Toppling, HardlyChangesBetweenNeighbouringDirections) {
  for (float angle = -kPi; angle <= kPi; angle += 0.01f)
    EXPECT_NEAR(odds(2.f * direction(angle)), odds(2.f * direction(angle + 0.01f)), 0.05f) << angle;
}

TEST(Collisions, TwoEqualRobotsShareTheImpulse) {
  // m/2 of each unit of closing speed, and as much again for the share with which they part
  const auto strength = [](float bounce) {
    return length(CollisionModel{.mass = 5.3f, .bounce = bounce, .soft = 0}.impulse({0.24f, -0.32f}));
  };
  EXPECT_NEAR(strength(0), 1.06f, 1e-5f);
  EXPECT_NEAR(strength(1), 2.12f, 1e-5f);
}

TEST(Manner, GoesByTheVelocity) {
  EXPECT_EQ(manner_of({0.05f, 0}, 0), Manner::slow);
  EXPECT_EQ(manner_of({-0.1f, 0}, 0), Manner::slow);
  EXPECT_EQ(manner_of({0.215f, 0.05f}, 0.1f), Manner::ahead);
  EXPECT_EQ(manner_of({0.16f, 0}, 0), Manner::ahead);
  EXPECT_EQ(manner_of({0.25f, 0}, 0), Manner::fast);
  EXPECT_EQ(manner_of({0.05f, -0.1f}, 0), Manner::sideways);
  EXPECT_EQ(manner_of({0.2f, 0}, -0.5f), Manner::turning);
}

Arena with_table(std::uint64_t seed, float soft = 0) {
  Arena arena;
  arena.effects.falls = true;
  arena.effects.walk_delay = false;
  arena.model.falls.table = table_of(soft);
  arena.world.key.seed = seed;
  return arena;
}

constexpr int kRobots = 2000;

/// Returns the share of robots that fall in such a collision.
float share_toppled(Vec2 closing, Doing doing, float soft = 0, bool effect = true) {
  int fallen = 0;
  for (int seed = 0; seed < kRobots; ++seed) {
    Arena arena = with_table(static_cast<std::uint64_t>(seed), soft);
    arena.effects.falls = effect;
    arena.model.falls.table.soft.walking.half[0] = arena.model.falls.table.soft.standing.half[0] = 1;
    arena.model.falls.table.stiff.walking.half[0] = 3;
    arena.body().doing = doing;
    topple({arena.model, arena.effects, arena.ball}, closing, Arena::kRobot, arena.world);
    fallen += arena.body().doing == Doing::fallen ? 1 : 0;
  }
  return static_cast<float>(fallen) / kRobots;
}

TEST(FallTable, ACollisionTopplesAsManyAsTheTableSays) {
  // 0.5 * 5 kg * 1.2 * 0.6 m/s: 1.8 N s to the front
  const Vec2 collision{0.6f, 0};
  const auto expected = [](float half) { return 1 / (1 + std::pow(half / 1.8f, 6.f)); };
  EXPECT_NEAR(share_toppled(collision, Doing::standing), expected(2), 0.03f);
  EXPECT_NEAR(share_toppled(collision, Doing::walking), expected(3), 0.03f);
  EXPECT_NEAR(share_toppled(collision, Doing::walking, 1), expected(1), 0.03f);
  EXPECT_NEAR(share_toppled(collision, Doing::walking, 0.5f), 0.5f * (expected(1) + expected(3)), 0.03f);
}

TEST(FallTable, NobodyIsToppledWithoutTheEffectWithoutACollisionOrOnTheGround) {
  const Vec2 hard{100, 0};
  EXPECT_EQ(share_toppled(hard, Doing::standing), 1);
  EXPECT_EQ(share_toppled(hard, Doing::standing, 0, /*effect=*/false), 0);
  EXPECT_EQ(share_toppled({}, Doing::standing), 0);
  EXPECT_EQ(share_toppled(hard, Doing::getting_up), 0);
  EXPECT_EQ(share_toppled(hard, Doing::removed), 0);
  Arena arena = with_table(1);
  arena.model.falls.table.given = false;
  topple({arena.model, arena.effects, arena.ball}, hard, Arena::kRobot, arena.world);
  EXPECT_EQ(arena.body().doing, Doing::standing);
}

/// Returns the share of robots that fall within `duration` [s] with this velocity.
float share_fallen(const Command& command, bool touching, float soft, int duration) {
  int fallen = 0;
  for (int seed = 0; seed < kRobots; ++seed) {
    Arena arena = with_table(static_cast<std::uint64_t>(seed), soft);
    arena.effects.walk_noise = arena.effects.walk_acceleration = false;
    arena.body().touching = touching ? 10 : 0;
    for (int tick = 0; tick < 30 * duration && arena.body().doing != Doing::fallen; ++tick) arena.move(command);
    fallen += arena.body().doing == Doing::fallen ? 1 : 0;
  }
  return static_cast<float>(fallen) / kRobots;
}

TEST(FallTable, RobotsFallByThemselvesAtTheRateOfTheirManner) {
  const auto within = [](float per_minute, float seconds) { return 1 - std::exp(-per_minute * seconds / 60); };
  EXPECT_NEAR(share_fallen({}, false, 0, 10), within(1, 10), 0.03f);
  EXPECT_NEAR(share_fallen(walk_speed({0.2f, 0}, 0), false, 0, 10), within(3, 10), 0.035f);
  EXPECT_NEAR(share_fallen(walk_speed({0, 0.15f}, 0), false, 0, 10), within(5, 10), 0.035f);
  EXPECT_NEAR(share_fallen(walk_speed({}, 1), false, 0, 10), within(6, 10), 0.035f);
  EXPECT_NEAR(share_fallen({}, true, 0, 10), within(7, 10), 0.035f);
  EXPECT_NEAR(share_fallen(walk_speed({0.2f, 0}, 0), true, 0, 10), within(8, 10), 0.035f);
}

TEST(FallTable, TheServosOfARobotStayTheSame) {
  // soft ones never fall by themselves here, so half of the robots fall sooner or later and the others never
  EXPECT_NEAR(share_fallen(walk_speed({}, 1), false, 0.5f, 120), 0.5f, 0.04f);
}

}  // namespace
}  // namespace sim::motion
