// The synthetic robot's body: sensors, joints and motion status.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/lab/synthetic/synthetic_messages.h"

namespace robot::lab::synthetic {
namespace {

constexpr double kTau = 2 * std::numbers::pi;
constexpr double kStepSeconds = 0.5;  // two steps of the walk
constexpr double kFullSpeed = 0.324;  // [m/s]
constexpr double kGravity = 9.81;     // [m/s²]
constexpr double kMass = 5.3;         // [kg]

/// Returns the walking speed as a share: 0 standing .. 1 full speed.
double gait(double t) { return std::min(1.0, walker_at(t).speed / kFullSpeed); }

/// Returns the phase of the walk within two steps, as an angle.
double phase(double t) { return kTau * t / kStepSeconds; }

/// The direction of the head's attention: sideways -1 .. 1; `near` is 1 if the ball is at the feet.
struct Look {
  double aside = 0, near = 0;
};

/// Returns the mean over half a second, so that the head does not jump when the referee moves the ball.
Look look_at_ball(double t) {
  constexpr int kSamples = 10;
  Look mean;
  for (int i = 0; i < kSamples; ++i) {
    const auto ball = ball_at(t - 0.05 * i);
    if (!ball) continue;
    const Walker walker = walker_at(t - 0.05 * i);
    const Point seen = relative(ball->position, walker.position, walker.heading);
    const double distance = std::hypot(seen.x, seen.y);
    mean.aside += seen.y / distance / kSamples;
    mean.near += std::clamp(1.2 - distance, 0.0, 1.0) / kSamples;
  }
  return mean;
}

/// Returns the share of the kick's movement, 0 .. 1. The robot leans forward with it.
double kick_swing(double t) { return std::max(0.0, 1 - std::abs(t - kKick) / 0.3); }

}  // namespace

double Noise::operator()(Stream stream, std::uint64_t step) const {
  // four uniform numbers by the mixing function of SplitMix64; their sum is nearly normal
  double sum = 0;
  for (std::uint64_t i = 0; i < 4; ++i) {
    std::uint64_t z = (seed_ * 64 + stream) * 0x9e3779b97f4a7c15 + (4 * step + i + 1) * 0xd1342543de82ef95;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    sum += static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
  }
  return (sum - 2) * std::numbers::sqrt3;
}

Bearing bearing_at(double t) {
  const Look look = look_at_ball(t);
  return {.head_yaw = 1.15 * look.aside + 0.3 * std::sin(kTau * t / 3),
          .head_pitch = 0.14 + 0.05 * std::sin(kTau * t / 2.6) + 0.3 * look.near,
          .torso_roll = 0.03 * gait(t) * std::sin(phase(t)),
          .torso_pitch = 0.02 + 0.01 * gait(t) * std::sin(2 * phase(t)) + 0.08 * kick_swing(t)};
}

pb::Joints joints_of(const SyntheticMoment& moment, const Noise& noise) {
  const double walking = gait(moment.t), swing = walking * std::sin(phase(moment.t)), kick = kick_swing(moment.t);
  const double lift_left = walking * std::max(0.0, std::sin(phase(moment.t))),
               lift_right = walking * std::max(0.0, -std::sin(phase(moment.t)));
  const Bearing bearing = bearing_at(moment.t);
  const double commanded[25] = {bearing.head_yaw,
                                bearing.head_pitch,  // head
                                1.55 - 0.2 * swing,
                                0.2,
                                -1.5,
                                -0.3,
                                0,  // left arm
                                0.04 * walking,
                                0.05 * swing,
                                -0.4 - 0.15 * swing - 0.15 * lift_left,  // left leg
                                0.85 + 0.3 * lift_left,
                                -0.45 + 0.1 * swing - 0.15 * lift_left,
                                -0.05 * swing,
                                0.05 * swing,
                                -0.4 + 0.15 * swing - 0.15 * lift_right - 0.5 * kick,  // right leg
                                0.85 + 0.3 * lift_right + 0.2 * kick,
                                -0.45 - 0.1 * swing - 0.15 * lift_right + 0.3 * kick,
                                -0.05 * swing,
                                1.55 + 0.2 * swing,
                                -0.2,
                                1.5,
                                0.3,
                                0,
                                0,
                                0};  // right arm, hands
  pb::Joints joints;
  for (std::uint64_t i = 0; i < 25; ++i) {
    const bool leg = i >= 7 && i <= 17;
    joints.add_commanded(narrow(commanded[i]));
    joints.add_position(narrow(commanded[i] + 0.004 * noise(Noise::kJoints, 25 * moment.step + i)));
    joints.add_stiffness(leg ? 0.9f : 0.5f);
    joints.add_temperature(narrow((leg ? 45 : 36) + 0.3 * moment.t * (leg ? walking : 0.1)));
    joints.add_current(narrow(leg ? 0.3 + 0.5 * std::abs(swing) : 0.05));
    joints.add_status(0);
  }
  return joints;
}

pb::Inertial inertial_of(const SyntheticMoment& moment, const Noise& noise) {
  const Bearing now = bearing_at(moment.t), before = bearing_at(moment.t - 0.01);
  const auto jitter = [&](std::uint64_t axis) { return noise(Noise::kInertial, 8 * moment.step + axis); };
  pb::Inertial inertial;
  inertial.set_accelerometer_x(narrow(-kGravity * std::sin(now.torso_pitch) + 0.15 * jitter(0)));
  inertial.set_accelerometer_y(narrow(kGravity * std::sin(now.torso_roll) + 0.15 * jitter(1)));
  inertial.set_accelerometer_z(
      narrow(kGravity + gait(moment.t) * 1.2 * std::sin(2 * phase(moment.t)) + 0.15 * jitter(2)));
  inertial.set_gyroscope_x(narrow((now.torso_roll - before.torso_roll) / 0.01 + 0.01 * jitter(3)));
  inertial.set_gyroscope_y(narrow((now.torso_pitch - before.torso_pitch) / 0.01 + 0.01 * jitter(4)));
  inertial.set_gyroscope_z(narrow(walker_at(moment.t).turn_rate + 0.01 * jitter(5)));
  inertial.set_torso_roll(narrow(now.torso_roll));
  inertial.set_torso_pitch(narrow(now.torso_pitch));
  return inertial;
}

pb::Fsr fsr_of(const SyntheticMoment& moment) {
  // the weight moves from foot to foot, and to the left foot for the kick
  const double swing = gait(moment.t) * std::sin(phase(moment.t));
  const double left = std::clamp(0.5 - 0.5 * swing + 0.5 * kick_swing(moment.t), 0.0, 1.0);
  const float of_left = narrow(kMass * left / 4), of_right = narrow(kMass * (1 - left) / 4);
  pb::Fsr fsr;
  fsr.set_left_front_left(of_left);
  fsr.set_left_front_right(of_left);
  fsr.set_left_rear_left(of_left);
  fsr.set_left_rear_right(of_left);
  fsr.set_right_front_left(of_right);
  fsr.set_right_front_right(of_right);
  fsr.set_right_rear_left(of_right);
  fsr.set_right_rear_right(of_right);
  return fsr;
}

pb::Touch touch_of(const SyntheticMoment& moment) {
  pb::Touch touch;
  touch.set_chest_button(moment.t >= 0.6 && moment.t < 0.8);
  touch.set_right_foot_left(std::abs(moment.t - kKick) < 0.025);  // the ball at the bumper
  return touch;
}

pb::Battery battery_of(const SyntheticMoment& moment) {
  pb::Battery battery;
  battery.set_charge(narrow(0.83 - 0.0004 * moment.t));
  battery.set_current(narrow(-1.6 - 0.9 * gait(moment.t)));
  battery.set_temperature(narrow(36 + 0.02 * moment.t));
  return battery;
}

pb::Odometry odometry_of(const SyntheticMoment& moment) {
  // odometry has a systematic error: steps are a little too long, turns a little too small
  constexpr double kTooLong = 1.05, kTooStraight = 0.97;
  const Walker start = walker_at(0), now = walker_at(moment.t);
  const Point moved = relative(now.position, start.position, start.heading);
  pb::Odometry odometry;
  odometry.set_x(narrow(kTooLong * moved.x));
  odometry.set_y(narrow(kTooLong * moved.y));
  odometry.set_heading(narrow(normalised(kTooStraight * normalised(now.heading - start.heading))));
  return odometry;
}

pb::MotionStatus motion_status_of(const SyntheticMoment& moment) {
  const Walker walker = walker_at(moment.t);
  const bool walking = walker.speed > 0, kicks = std::abs(moment.t - kKick) < 0.3;
  pb::MotionStatus status;
  status.set_body_active(walking);
  status.set_head_active(true);
  status.set_walking(walking);
  status.set_standing(!walking);
  status.set_calibrated(moment.t > 1);
  if (kicks) status.set_running("walk_forward");
  if (kicks) status.set_remaining(narrow(kKick + 0.3 - moment.t));
  status.set_fall(pb::MotionStatus::FALL_UPRIGHT);
  const double swing = std::sin(phase(moment.t));
  status.set_support_foot(!walking    ? pb::MotionStatus::SUPPORT_FOOT_BOTH
                          : swing > 0 ? pb::MotionStatus::SUPPORT_FOOT_RIGHT
                                      : pb::MotionStatus::SUPPORT_FOOT_LEFT);
  status.set_ground_contact(true);
  status.set_velocity_x(narrow(walker.speed));
  status.set_turn_rate(narrow(walker.turn_rate));
  return status;
}

}  // namespace robot::lab::synthetic
