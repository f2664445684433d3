#include "robot/nao/motion/walking_legs.h"

#include <algorithm>
#include <optional>

#include "robot/nao/motion/leg_joints.h"

namespace robot::nao {
walk::Sensors walking_sensors(const Report& report) {
  const Sensors& from = report.sensors;
  walk::Sensors sensors;
  std::copy(from.gyroscope.begin(), from.gyroscope.end(), sensors.rate.begin());
  sensors.roll = from.angles[0], sensors.pitch = from.angles[1];
  for (const walk::Side side : {walk::left, walk::right})
    std::copy_n(&from.fsr[4 * static_cast<std::size_t>(side)], 4, sensors.load[side].begin());
  sensors.joints = legs_of(from.position);
  return sensors;
}

void WalkingLegs::drive(const Report& report, const walk::Command& command, float dt, Order& order) {
  if (report.mode != Mode::playing || report.doing != Doing::standing || order.posture != Order::Posture::stand) {
    walk_.reset();
    return;
  }
  if (take_over(report, dt)) {
    const walk::Sensors sensors = walking_sensors(report);
    const double share = share_of_speed(report);
    walk::Command slower = command;
    slower.forward *= share, slower.left *= share, slower.turn *= share;
    targets_ = walk_->tick(sensors, slower, dt);
    stops_ = command.stands();
    odometry_.see(sensors, steps() ? std::optional(other(walk_->swing())) : std::nullopt, dt);
  }
  put_legs(targets_, order.position);
  for_each_leg_joint([&](walk::Side, std::size_t, Joint name) {
    order.drives[name] = 1;
    order.stiffness[name] = kStiffness;
  });
}

void WalkingLegs::change(const walk::Parameters& parameters) {
  parameters_ = parameters;
  if (walk_) walk_->change(parameters);
}

/// Moves the legs to the stand of the walk. Returns true when they are there.
bool WalkingLegs::take_over(const Report& report, float dt) {
  if (!walk_) {
    walk_.emplace(parameters_);
    from_ = legs_of(report.commanded);
    taken_ = 0;
  }
  if (taken_ >= kTakeOver) return true;
  taken_ += dt;
  const double part = std::min(taken_ / kTakeOver, 1.0f), smooth = part * part * (3 - 2 * part);
  const walk::Legs stand = walk::stand(walk_->parameters());
  for_each_leg_joint([&](walk::Side side, std::size_t joint, Joint) {
    targets_[side][joint] = from_[side][joint] + smooth * (stand[side][joint] - from_[side][joint]);
  });
  return false;
}

void WalkingLegs::fill_status(foresight::MotionStatus& status) const {
  if (!steps()) return;
  status.set_walking(true);
  status.set_body_active(true);
  status.set_standing(false);
  status.set_stopping(stops_);
  status.set_support_foot(walk_->swing() == walk::left ? foresight::MotionStatus::SUPPORT_FOOT_RIGHT
                                                       : foresight::MotionStatus::SUPPORT_FOOT_LEFT);
  const walk::Command& speed = walk_->speed();
  status.set_velocity_x(static_cast<float>(speed.forward));
  status.set_velocity_y(static_cast<float>(speed.left));
  status.set_turn_rate(static_cast<float>(speed.turn));
}

}  // namespace robot::nao
