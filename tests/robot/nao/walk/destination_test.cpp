#include "robot/nao/walk/destination.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace robot::nao::walk {
namespace {

/// Moves a robot that obeys at once. Returns the rest of the way after `seconds`.
Destination walked(Destination rest, double seconds) {
  constexpr double kStep = 0.02;
  for (double time = 0; time < seconds; time += kStep) {
    const Command command = towards(rest, 1, {});
    const double x = rest.x - command.forward * kStep, y = rest.y - command.left * kStep;
    const double turn = command.turn * kStep;
    rest = {x * std::cos(turn) + y * std::sin(turn), y * std::cos(turn) - x * std::sin(turn),
            std::remainder(rest.heading - turn, 2 * std::numbers::pi)};
  }
  return rest;
}

TEST(Destination, IsReachedFromEverywhereAndWithEachHeading) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> metres(-2, 2), radians(-3.1, 3.1);
  for (int i = 0; i < 500; ++i) {
    const Destination rest = walked({metres(random), metres(random), radians(random)}, 40);
    EXPECT_LT(std::hypot(rest.x, rest.y), 0.041) << "case " << i;
    EXPECT_LT(std::abs(rest.heading), 0.201) << "case " << i;
    EXPECT_TRUE(towards(rest, 1, {}).stands());
  }
}

TEST(Destination, AGainOfZeroStops) { EXPECT_TRUE(towards({1, 1, 1}, 0, {}).stands()); }

TEST(Destination, TheGainIsTheShareOfTheGreatestSpeed) {
  EXPECT_DOUBLE_EQ(towards({2, 0, 0}, 1, {}).forward, Limits{}.forward);
  EXPECT_DOUBLE_EQ(towards({2, 0, 0}, 0.5, {}).forward, 0.5 * Limits{}.forward);
  EXPECT_DOUBLE_EQ(towards({2, 0, 0}, 7, {}).forward, Limits{}.forward);
}

TEST(Destination, NoCommandExceedsTheLimits) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-5, 5);
  const Limits limits;
  for (int i = 0; i < 1000; ++i) {
    const Command command = within(limits, {any(random), any(random), any(random)});
    EXPECT_LE(command.forward, limits.forward + 1e-12);
    EXPECT_GE(command.forward, -limits.backward - 1e-12);
    EXPECT_LE(std::abs(command.left), limits.left + 1e-12);
    EXPECT_LE(std::abs(command.turn), limits.turn);
  }
}

TEST(Destination, ACommandWithinTheLimitsIsKept) {
  const Command command = within({}, {0.1, 0.02, 0.1});
  EXPECT_DOUBLE_EQ(command.forward, 0.1);
  EXPECT_DOUBLE_EQ(command.left, 0.02);
  EXPECT_DOUBLE_EQ(command.turn, 0.1);
}

}  // namespace
}  // namespace robot::nao::walk
