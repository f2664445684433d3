// Tests of falls by a table.
#include "sim/motion/fall_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/sim/motion/arena.h"

namespace sim::motion {
namespace {

using Doing = Body::Doing;

constexpr Toppling kToppling{.slope = 6, .half = {2, 2.2f, 2.4f, 2.6f, 3, 2.8f, 2.3f, 2.1f}};

constexpr GettingUp kStiffUp{
    .lying = 1, .back = 4, .front = 6, .side = 5, .back_failure = 0.1f, .front_failure = 0.3f, .side_failure = 0.2f};
constexpr GettingUp kSoftUp{
    .lying = 2, .back = 7, .front = 9, .side = 8, .back_failure = 0, .front_failure = 0, .side_failure = 0};

/// Returns a table whose classes differ in how often their robots fall, and in how they get up.
FallTable table_of(float soft) {
  const ServoClass stiff{.rates = {.per_minute = {1, 2, 3, 4, 5, 6}, .shoved_standing = 7, .shoved_walking = 8},
                         .standing = kToppling,
                         .walking = kToppling,
                         .getting_up = kStiffUp};
  return {.given = true,
          .collisions = {.mass = 5, .bounce = 0.2f, .soft = soft},
          .alone = {.front = 0.5f, .back = 0.3f},
          .stiff = stiff,
          .soft = {.rates = {}, .standing = kToppling, .walking = kToppling, .getting_up = kSoftUp}};
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

TEST(FallTable, ARobotLiesWhereItWasPushed) {
  for (int degrees = -175; degrees <= 180; degrees += 10) {
    const Lying expected = std::abs(degrees) < 45    ? Lying::on_front
                           : std::abs(degrees) > 135 ? Lying::on_back
                           : degrees > 0             ? Lying::on_left
                                                     : Lying::on_right;
    EXPECT_EQ(lying_after(direction(static_cast<float>(degrees) * kPi / 180)), expected) << degrees;
    Arena arena = with_table(1);
    topple({arena.model, arena.effects, arena.ball}, 100 * direction(static_cast<float>(degrees) * kPi / 180),
           Arena::kRobot, arena.world);
    ASSERT_EQ(arena.body().doing, Doing::fallen);
    EXPECT_EQ(Lying{arena.body().kind}, expected) << degrees;
  }
}

TEST(FallTable, FallsAloneEndOnTheSidesOfTheTable) {
  std::array<int, 4> lie{};
  for (int seed = 0; seed < kRobots; ++seed) {
    Arena arena = with_table(static_cast<std::uint64_t>(seed));
    arena.model.falls.table.stiff.rates.per_minute[0] = 600;
    while (arena.body().doing != Doing::fallen) arena.move({});
    ++lie[arena.body().kind];
  }
  const auto share = [&](Lying lying) { return static_cast<float>(lie[static_cast<std::size_t>(lying)]) / kRobots; };
  EXPECT_NEAR(share(Lying::on_front), 0.5f, 0.04f);
  EXPECT_NEAR(share(Lying::on_back), 0.3f, 0.04f);
  EXPECT_NEAR(share(Lying::on_left), 0.1f, 0.03f);
  EXPECT_NEAR(share(Lying::on_right), 0.1f, 0.03f);
}

TEST(FallTable, GettingUpTakesTheTimeOfItsSideAndFailsAsOften) {
  for (const float soft : {0.f, 1.f})
    for (const Lying lying : {Lying::on_back, Lying::on_front, Lying::on_left, Lying::on_right}) {
      const GettingUp& up = soft > 0 ? kSoftUp : kStiffUp;
      int failed = 0;
      for (int seed = 0; seed < kRobots; ++seed) {
        Arena arena = with_table(static_cast<std::uint64_t>(seed), soft);
        arena.body().doing = Doing::fallen;
        arena.body().kind = static_cast<std::uint8_t>(lying);
        for (Tick tick = 0; tick < ticks(up.lying); ++tick) arena.move({});
        ASSERT_EQ(arena.body().doing, Doing::getting_up);
        ASSERT_EQ(arena.body().since, ticks(up.lying));
        for (Tick tick = 0; tick + 1 < ticks(up.seconds(lying)); ++tick) arena.move({});
        ASSERT_EQ(arena.body().doing, Doing::getting_up);
        arena.move({});
        ASSERT_NE(arena.body().doing, Doing::getting_up);
        failed += arena.body().doing == Doing::fallen ? 1 : 0;
        ASSERT_EQ(Lying{arena.body().kind}, lying);
      }
      EXPECT_NEAR(static_cast<float>(failed) / kRobots, up.failure(lying), 0.04f);
    }
}

TEST(FallTable, TheUsualTimeIsTheMeanOfSidesAndServos) {
  // stiff: 1 + 0.5 * 6 + 0.3 * 4 + 0.2 * 5; soft: 2 + 0.5 * 9 + 0.3 * 7 + 0.2 * 8
  EXPECT_NEAR(table_of(0).usual_time(), 6.2f, 1e-5f);
  EXPECT_NEAR(table_of(1).usual_time(), 10.2f, 1e-5f);
  EXPECT_NEAR(table_of(0.25f).usual_time(), 7.2f, 1e-5f);
  EXPECT_EQ((Falls{.lying = 1, .getting_up = 2.5f}).usual_time(), 3.5f);
}

}  // namespace
}  // namespace sim::motion
