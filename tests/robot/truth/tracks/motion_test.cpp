#include "robot/truth/tracks/motion.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/tracks/images.h"

namespace robot::truth {
namespace {

SharedErrors some_errors() {
  SharedErrors errors = no_errors();
  errors[0] = 0.001 * Eigen::Matrix2d::Identity();
  return errors;
}

TEST(RobotStep, TwoHalfStepsAreOneWholeStep) {
  for (const double dt : {1e-4, 1. / 30, 0.5, 4.}) {
    const Estimate first = first_estimate({0, seen_at(1, 2)}, some_errors(), kRobotSpeed);
    const Step half = robot_step(some_errors(), dt / 2);
    const Estimate twice = predicted(predicted(first, half), half);
    const Estimate once = predicted(first, robot_step(some_errors(), dt));
    EXPECT_LT((twice.mean - once.mean).norm(), 1e-12);
    EXPECT_LT((twice.covariance - once.covariance).norm(), 1e-9) << dt;
  }
}

TEST(RobotStep, OfAHiddenRobotStaysWithinReach) {
  // 2 s after it was seen, along its straight line
  EXPECT_NEAR(std::sqrt(robot_step(no_errors(), 2).noise(0, 0)), 0.35, 0.01);
  // half a second changes its velocity by 0.2 m/s
  EXPECT_NEAR(std::sqrt(robot_step(no_errors(), 0.5).noise(2, 2)), 0.2, 0.02);
}

Estimate rolling(double velocity) {
  Estimate ball;
  ball.mean[2] = velocity;
  return ball;
}

TEST(BallStep, SlowsTheBallDownByItsFriction) {
  const Estimate after = predicted(rolling(1.5), ball_step(rolling(1.5), no_errors(), 2));
  EXPECT_NEAR(after.velocity().x(), 1.5 - 2 * kBallFriction, 0.005);
  EXPECT_NEAR(after.position().x(), 2 * 1.5 - 2 * kBallFriction, 0.01);
  EXPECT_EQ(after.velocity().y(), 0);
}

TEST(BallStep, StopsTheBallAndDoesNotRollItBack) {
  const Estimate after = predicted(rolling(0.5), ball_step(rolling(0.5), no_errors(), 5));
  EXPECT_NEAR(after.velocity().x(), 0, 1e-3);
  EXPECT_GE(after.velocity().x(), 0);
  EXPECT_NEAR(after.position().x(), 0.5 * 0.5 / (2 * kBallFriction), 0.1);
}

TEST(BallStep, HasTheDerivativeOfTheMotion) {
  Estimate ball = rolling(0.4);
  ball.mean[3] = -0.3;
  const Step step = ball_step(ball, no_errors(), 0.3);
  for (int i = 0; i < 4; ++i) {
    Estimate other = ball;
    other.mean[i] += 1e-6;
    const Estimate::Mean change =
        predicted(other, ball_step(other, no_errors(), 0.3)).mean - predicted(ball, step).mean;
    EXPECT_LT((change.head<4>() / 1e-6 - step.transition.col(i)).norm(), 1e-4) << i;
  }
}

TEST(Kick, ChangesTheVelocityAtAnUnknownMoment) {
  Step step;
  add_kick(step, 0.1);
  EXPECT_DOUBLE_EQ(step.noise(2, 2), kKickSpeed * kKickSpeed);
  // a place between "at the beginning" and "at the end": uniform, so a third in the mean square
  EXPECT_DOUBLE_EQ(step.noise(0, 0), kKickSpeed * kKickSpeed * 0.1 * 0.1 / 3);
}

}  // namespace
}  // namespace robot::truth
