// A robot in the physics, as LoLA shows it to the guardian.
#pragma once

#include <cstdint>
#include <memory>

#include "robot/nao/lola/actuators.h"
#include "robot/nao/lola/sensors.h"
#include "tests/walk/drop.h"
#include "tests/walk/physics.h"

namespace robot::nao {

/// The legs are in the physics, and the arms of a body that moves them. Other joints follow at once and have no weight.
/// Only a body that moves its arms can get up: its limbs touch the ground.
class LolaBody {
 public:
  /// Puts a robot on its feet, in the guardian's stand and without stiffness. It stays there until it has stiffness.
  LolaBody(const walk::DrawnRobot& robot, std::uint64_t seed, bool with_ball = false, bool with_arms = false);

  Sensors sensors;  // LoLA's next values; others may change those that the physics does not have: touch, temperature …

  /// Moves the body on by one cycle of 12 ms and fills the sensors.
  void obey(const Actuators& actuators);

  /// Pushes the torso in the next 50 ms: an impulse [N s] towards `direction` [rad], 0 forward, > 0 to the left.
  void push(double impulse, double direction);

  /// Drops the robot onto the ground. Only of a body with arms.
  void drop(const Drop& drop);

  /// Puts the ball on the ground [m, robot]. Only of a body with a ball.
  void place_ball(double ahead, double left) { physics_.place_ball(ahead, left); }

  walk::Truth truth() const { return physics_.truth(); }
  /// Reports whether the robot has not fallen.
  bool upright() const;

 private:
  void sense();

  walk::Physics physics_;
  walk::Legs stand_{};
  bool with_arms_;
  bool held_ = true;  // by a person, until it has stiffness
  walk::DrawnRobot robot_;
  std::uint64_t seed_;
  double impulse_ = 0, direction_ = 0;
  int pushing_ = 0;  // steps of the physics left
};

}  // namespace robot::nao
