#include "robot/truth/tracks/motion.h"

#include <algorithm>
#include <cmath>

namespace robot::truth {
namespace {

constexpr double kOffsetMemory = 10;   // [s] a robot walks 3 m in it, where the error of a pose acts differently
constexpr double kBallNoise = 0.004;   // [m²/s³] bumps of the carpet, and friction that is wrong by 0.1 m/s²
constexpr double kSlowBall = 0.05;     // [m/s] slower balls are slowed down less, so that they do not roll back
constexpr double kBallSubstep = 0.05;  // [s] < kSlowBall / kBallFriction

/// Returns the covariance of place and velocity whose axes are independent and alike.
Eigen::Matrix4d alike(double place, double both, double velocity) {
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  covariance.diagonal() << place, place, velocity, velocity;
  covariance(0, 2) = covariance(2, 0) = covariance(1, 3) = covariance(3, 1) = both;
  return covariance;
}

void add_offsets(Step& step, const SharedErrors& shared, double dt) {
  step.offsets_kept = std::exp(-dt / kOffsetMemory);
  const double renewed = -std::expm1(-2 * dt / kOffsetMemory);
  for (std::size_t sensor = 0; sensor < kMostSensors; ++sensor) step.offset_noise[sensor] = renewed * shared[sensor];
}

/// Rolls the ball over a short `dt` [s] and adds this to the step.
void roll_on(Eigen::Vector4d& ball, Step& step, double dt) {
  const Eigen::Vector2d velocity = ball.tail<2>();
  const double speed = std::hypot(velocity.norm(), kSlowBall);
  const double slowed = kBallFriction * dt / speed;  // part of the velocity that is lost

  Eigen::Matrix4d change = Eigen::Matrix4d::Identity();
  const Eigen::Matrix2d of_velocity =
      (1 - slowed) * Eigen::Matrix2d::Identity() + slowed / (speed * speed) * velocity * velocity.transpose();
  change.bottomRightCorner<2, 2>() = of_velocity;
  change.topRightCorner<2, 2>() = dt / 2 * (Eigen::Matrix2d::Identity() + of_velocity);

  ball.head<2>() += (1 - slowed / 2) * dt * velocity;
  ball.tail<2>() = (1 - slowed) * velocity;
  step.transition = (change * step.transition).eval();
  step.noise =
      (change * step.noise * change.transpose()).eval() + kBallNoise * alike(dt * dt * dt / 3, dt * dt / 2, dt);
}

}  // namespace

Step robot_step(const SharedErrors& shared, double dt) {
  const double x = dt / kRobotMemory;
  const double lost = -std::expm1(-x), kept = 1 - lost;
  // the difference of large numbers is a series for short steps
  const double spread = x < 0.001 ? x * x * x * (2. / 3 - x / 2) : 2 * x - 3 + 4 * kept - kept * kept;

  Step step;
  step.transition.diagonal().tail<2>().setConstant(kept);
  step.transition(0, 2) = step.transition(1, 3) = kRobotMemory * lost;
  step.noise = kRobotSpeed * kRobotSpeed *
               alike(kRobotMemory * kRobotMemory * spread, kRobotMemory * lost * lost, lost * (1 + kept));
  add_offsets(step, shared, dt);
  return step;
}

Step ball_step(const Estimate& ball, const SharedErrors& shared, double dt) {
  Step step;
  Eigen::Vector4d state = ball.mean.head<4>();
  const int parts = std::max(1, static_cast<int>(std::ceil(dt / kBallSubstep)));
  for (int part = 0; part < parts; ++part) roll_on(state, step, dt / parts);
  step.shift = state - step.transition * ball.mean.head<4>();
  add_offsets(step, shared, dt);
  return step;
}

void add_kick(Step& step, double dt) { step.noise += kKickSpeed * kKickSpeed * alike(dt * dt / 3, dt / 2, 1); }

}  // namespace robot::truth
