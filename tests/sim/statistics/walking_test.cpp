#include "sim/statistics/walking.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/statistics/windows.h"

namespace sim::statistics {
namespace {

using tests::robot_of;

Window with(std::vector<Robot> robots) {
  return {.ball = Path(robots.front().frames.size()), .robots = std::move(robots)};
}

/// A robot on a circle.
Robot circling(double seconds, double speed, double radius) {
  return robot_of(0, 2, seconds, [=](double now) {
    const double angle = speed / radius * now;
    return Sighting{
        .position = {static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle))}};
  });
}

TEST(Walking, ARobotOnACircleHasItsSpeed) {
  const Walking walking = walking_of(with({circling(120, 0.2, 1)}));
  // the chord of 1 s is 0.17 % shorter than the arc, the mean over 11 frames takes off 0.02 %
  EXPECT_NEAR(walking.speed_median, 0.2, 0.001);
  EXPECT_NEAR(walking.speed_99, 0.2, 0.001);
  EXPECT_NEAR(walking.metres_per_minute, 12, 0.06);
  EXPECT_EQ(walking.standing, 0);
}

TEST(Walking, HalfTheRobotsStand) {
  const Robot still = robot_of(1, 3, 60, [](double) { return Sighting{.position = {1, 1}}; });
  const Walking walking = walking_of(with({circling(60, 0.3, 2), still}));
  EXPECT_NEAR(walking.standing, 0.5, 1e-9);
  EXPECT_NEAR(walking.speed_median, 0.3, 0.002);
  EXPECT_NEAR(walking.metres_per_minute, 9, 0.1);
}

TEST(Walking, ARobotThatIsCarriedDoesNotWalk) {
  const Robot carried = robot_of(0, 2, 60, [](double now) { return Sighting{.position = {now < 30 ? -3.f : 3.f, 0}}; });
  const Walking walking = walking_of(with({carried}));
  EXPECT_LT(walking.speed_99, 0.8);
  EXPECT_NEAR(walking.metres_per_minute, 0, 0.2);
}

TEST(Walking, CountsFallsAndTheTimeOnTheGround) {
  const Robot falling = robot_of(0, 2, 120, [](double now) {
    const bool down = (now >= 20 && now < 24) || (now >= 70 && now < 76);
    return Sighting{.position = {0, 0}, .down = down};
  });
  const Walking walking = walking_of(with({falling}));
  EXPECT_NEAR(walking.falls_per_minute, 1, 1e-9);
  EXPECT_NEAR(walking.down, 10. / 120, 0.01);
}

TEST(Walking, ARobotThatIsDownForAMomentDoesNotFall) {
  const Robot bending = robot_of(0, 2, 60, [](double now) {
    return Sighting{.position = {0, 0}, .down = now >= 20 && now < 20.6};
  });
  EXPECT_EQ(walking_of(with({bending})).falls_per_minute, 0);
}

TEST(Walking, ARobotThatLiesFromTheBeginningFellBefore) {
  const Robot lying = robot_of(0, 2, 60, [](double now) { return Sighting{.position = {0, 0}, .down = now < 5}; });
  EXPECT_EQ(walking_of(with({lying})).falls_per_minute, 1);
}

TEST(Walking, ARobotThatIsHardlySeenDoesNotCount) {
  const Robot still = robot_of(0, 2, 60, [](double) { return Sighting{.position = {0, 0}}; });
  const Robot guest = robot_of(0, 3, 60, [](double now) -> std::optional<Sighting> {
    if (now > 1.6) return std::nullopt;
    return Sighting{.position = {static_cast<float>(0.5 * now), 0}};
  });
  EXPECT_EQ(walking_of(with({still, guest})).standing, 1);
}

}  // namespace
}  // namespace sim::statistics
