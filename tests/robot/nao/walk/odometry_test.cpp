#include "robot/nao/walk/odometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/nao/walk/walk.h"

namespace robot::nao::walk {
namespace {

constexpr double kCycle = 0.012;  // [s]

/// Returns sensors of a robot whose left foot is at this place under the hip.
Sensors on_left_foot(double x, double y, double turn_rate = 0) {
  Sensors sensors;
  sensors.joints = reach({Sole{{x, y, -0.21}, 0}, Sole{{0, 0, -0.19}, 0}}, 0, 0);
  sensors.rate[2] = turn_rate;
  return sensors;
}

TEST(Odometry, TheTorsoMovesAgainstTheSupportFoot) {
  Odometry odometry;
  for (int i = 0; i <= 50; ++i) odometry.see(on_left_foot(0.02 - 0.001 * i, 0.0005 * i), left, kCycle);
  EXPECT_NEAR(odometry.way().x, 0.05, 1e-6);
  EXPECT_NEAR(odometry.way().y, -0.025, 1e-6);
  EXPECT_EQ(odometry.way().heading, 0);
}

TEST(Odometry, AnExchangeOfTheFeetIsNoWay) {
  Odometry odometry;
  odometry.see(on_left_foot(0.03, 0), left, kCycle);
  odometry.see(on_left_foot(0.03, 0), right, kCycle);
  odometry.see(on_left_foot(0.03, 0), left, kCycle);
  EXPECT_EQ(odometry.way().x, 0);
  EXPECT_EQ(odometry.way().y, 0);
}

TEST(Odometry, ATurnAboutTheSupportFootMovesTheTorsoOnACircle) {
  Odometry odometry;
  // the foot stays at its place in the torso, 5 cm to the left, and turns there
  constexpr double kRate = 0.5, kTurn = kRate * kCycle;
  for (int i = 0; i <= 40; ++i) odometry.see(on_left_foot(0, 0, kRate), left, kCycle);
  const double turned = kTurn * 40;
  EXPECT_NEAR(odometry.way().heading, kTurn * 41, 1e-9);
  EXPECT_NEAR(odometry.way().x, 0.05 * std::sin(turned), 2e-3);
  EXPECT_NEAR(odometry.way().y, 0.05 - 0.05 * std::cos(turned), 2e-3);
}

TEST(Odometry, LearnsTheBiasOfTheGyroscopeWhileTheRobotStands) {
  Odometry odometry;
  for (int i = 0; i < 1000; ++i) odometry.see(on_left_foot(0, 0, 0.02), std::nullopt, kCycle);
  for (int i = 0; i < 1000; ++i) odometry.see(on_left_foot(0, 0, 0.02), left, kCycle);
  EXPECT_NEAR(odometry.way().heading, 0, 1e-3);
  EXPECT_NEAR(odometry.way().x, 0, 1e-5);
}

TEST(Odometry, APlaceIsPassedAsTheRobotGoesOn) {
  const Way then{1, 2, 0.5};
  const Point same = passed(then, {0.3, -0.1, 0}, then);
  EXPECT_NEAR(same.x, 0.3, 1e-12);
  EXPECT_NEAR(same.y, -0.1, 1e-12);
  // 0.3 m ahead of the first robot, which then goes there and turns left
  const Way now{1 + 0.3 * std::cos(0.5), 2 + 0.3 * std::sin(0.5), 0.5 + std::acos(-1) / 2};
  const Point left_behind = passed(then, {0.3, -0.1, 0}, now);
  EXPECT_NEAR(left_behind.x, -0.1, 1e-12);
  EXPECT_NEAR(left_behind.y, 0, 1e-12);
}

}  // namespace
}  // namespace robot::nao::walk
