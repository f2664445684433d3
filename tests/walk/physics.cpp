#include "tests/walk/physics.h"

#include <algorithm>
#include <cmath>

namespace robot::nao::walk {
namespace {

constexpr double kTorsoAboveHip = 0.085;  // [m] from the hips to the origin of the torso
constexpr double kAngleNoise = 0.003;     // [rad]
constexpr double kLoadNoise = 0.02;       // [kg]
constexpr double kDroppedFrom = 0.25;     // [m] height of the torso
// by joint: speeds without load and torques of the motors with their gears
constexpr std::array<double, kLegJoints> kSpeed = {4.16, 4.16, 6.4, 6.4, 6.4, 4.16};      // [rad/s]
constexpr std::array<double, kLegJoints> kTorque = {13.69, 13.69, 8.9, 8.9, 8.9, 13.69};  // [N m]
constexpr std::array<double, kArmJoints> kArmSpeed = {8.27, 7.19, 8.27, 7.19};            // [rad/s]
constexpr std::array<double, kArmJoints> kArmTorque = {2.149, 2.477, 2.149, 2.477};       // [N m]

bool is_of_arm(std::size_t motor) { return motor >= kLegMotors; }
std::size_t arm_joint(std::size_t motor) { return (motor - kLegMotors) % kArmJoints; }

/// Returns the angles of the limbs as those of the motors.
PerMotor motors_of(const Legs& legs, const Arms& arms = {}) {
  PerMotor angles{};
  auto next = angles.begin();
  for (const auto& leg : legs) next = std::copy(leg.begin(), leg.end(), next);
  for (const auto& arm : arms) next = std::copy(arm.begin(), arm.end(), next);
  return angles;
}

}  // namespace

Physics::Physics(const Scene& scene) : engine_(scene.ode ? ode_engine(scene) : mujoco_engine(scene)) {}

void Physics::reset(const DrawnRobot& robot, std::uint64_t seed, const Legs& legs, double hip_height,
                    const Arms& arms) {
  robot_ = robot;
  offset_ = motors_of(robot.offset);
  dice_ = Dice(seed * 2654435761u + 17);
  target_ = {.angles = motors_of(legs, arms)};
  engine_->reset(robot, dice_, target_.angles, hip_height + kTorsoAboveHip + 0.002 + robot.turf);
  queue_.clear();
  roll_ = pitch_ = sensed_at_ = 0;
}

void Physics::drop(const DrawnRobot& robot, std::uint64_t seed, const Legs& legs, const Arms& arms, double roll,
                   double pitch) {
  reset(robot, seed, legs, 0, arms);
  // first about the torso's x, then about the world's y
  const double a = std::cos(pitch / 2), b = std::sin(pitch / 2), c = std::cos(roll / 2), d = std::sin(roll / 2);
  engine_->turn(kDroppedFrom, {a * c, a * d, b * c, -b * d});
  pitch_ = pitch, roll_ = roll;
}

Sensors Physics::sense() {
  Sensors sensors;
  const double dt = now() - sensed_at_;
  sensed_at_ = now();
  const std::array<double, 3> rate = engine_->rate();
  for (std::size_t i = 0; i < 3; ++i)
    sensors.rate[i] = rate[i] + robot_.rate_bias[i] + robot_.rate_noise * dice_.normal();

  const std::array<double, 9> rotation = engine_->rotation();
  const double share = robot_.angle_lag > 0 ? dt / (dt + robot_.angle_lag) : 1;
  pitch_ += share * (std::asin(std::clamp(-rotation[6], -1.0, 1.0)) - pitch_);
  roll_ += share * (std::atan2(rotation[7], rotation[8]) - roll_);
  sensors.pitch = pitch_ + robot_.pitch_bias + kAngleNoise * dice_.normal();
  sensors.roll = roll_ + robot_.roll_bias + kAngleNoise * dice_.normal();

  const std::array<double, 8> loads = engine_->loads();
  for (std::size_t i = 0; i < 8; ++i)
    sensors.load[i / 4][i % 4] = std::max(0.0, robot_.load_gain[i] * loads[i] / kGravity + kLoadNoise * dice_.normal());
  for (std::size_t motor = 0; motor < kLegMotors; ++motor)
    sensors.joints[motor / kLegJoints][motor % kLegJoints] = engine_->joint(motor).angle + offset_[motor];
  return sensors;
}

void Physics::command(const Legs& targets, double stiffness, const Arms& arms) {
  queue_.push_back({now() + robot_.delay, motors_of(targets, arms), stiffness});
}

/// Returns the torque of a servo. A motor has less torque at speed.
double Physics::torque(std::size_t motor) const {
  const bool arm = is_of_arm(motor);
  const double most = arm ? kArmTorque[arm_joint(motor)] : kTorque[motor % kLegJoints];
  const double fastest = arm ? kArmSpeed[arm_joint(motor)] : kSpeed[motor % kLegJoints];
  const auto [angle, speed] = engine_->joint(motor);
  double error = target_.angles[motor] - offset_[motor] - angle;
  const double half = robot_.play / 2;
  error -= std::clamp(error, -half, half);
  const double warmth = robot_.warms > 0 ? std::min(1.0, now() / robot_.warms) : 0;
  const double gain = robot_.gain + warmth * std::min(0.0, kSoftGain - robot_.gain);
  const double wanted = target_.stiffness * (arm ? kArmShare : 1) * gain * error;
  const double left_over = std::clamp(1 - std::copysign(1.0, wanted) * speed / fastest, 0.0, 1.0);
  const double limit = most * (robot_.torque + warmth * std::min(0.0, kSoftTorque - robot_.torque)) * left_over;
  return std::clamp(wanted, -limit, limit);
}

void Physics::step(double force_x, double force_y) {
  while (!queue_.empty() && queue_.front().time <= now() + 1e-9) {
    target_ = queue_.front();
    queue_.pop_front();
  }
  for (std::size_t motor = 0; motor < engine_->motors(); ++motor) engine_->drive(motor, torque(motor));
  engine_->push(force_x, force_y);
  engine_->step();
}

Truth Physics::truth() const {
  const std::array<double, 9> rotation = engine_->rotation();
  const auto [x, y, height] = engine_->position();
  Truth truth{.x = x,
              .y = y,
              .height = height,
              .heading = std::atan2(rotation[3], rotation[0]),
              .upright = rotation[8],
              .face_up = rotation[6]};
  // the torso's z axis points where it tips
  truth.fall_direction = std::remainder(std::atan2(rotation[5], rotation[2]) - truth.heading, 2 * M_PI);
  if (engine_->has_ball()) {
    const RollingBall ball = engine_->ball();
    truth.ball_x = ball.x, truth.ball_y = ball.y;
    truth.ball_speed = std::hypot(ball.vx, ball.vy);
    truth.ball_direction = std::remainder(std::atan2(ball.vy, ball.vx) - truth.heading, 2 * M_PI);
  }
  return truth;
}

Arms Physics::arms() const {
  Arms arms{};
  for (std::size_t motor = kLegMotors; motor < engine_->motors(); ++motor)
    arms[(motor - kLegMotors) / kArmJoints][arm_joint(motor)] = engine_->joint(motor).angle;
  return arms;
}

double Physics::now() const { return engine_->now(); }

void Physics::place_ball(double ahead, double left_of, double speed) {
  const Truth robot = truth();
  const double cosine = std::cos(robot.heading), sine = std::sin(robot.heading);
  engine_->place({.x = robot.x + ahead * cosine - left_of * sine,
                  .y = robot.y + ahead * sine + left_of * cosine,
                  .vx = speed * cosine,
                  .vy = speed * sine});
}

}  // namespace robot::nao::walk
