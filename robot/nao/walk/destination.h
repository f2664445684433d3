// Speeds that lead to a place.
#pragma once

#include "robot/nao/walk/sensors.h"

namespace robot::nao::walk {

/// The fastest commands with which simulated robots stay on their feet (tests/walk).
struct Limits {
  double forward = 0.2, backward = 0.12, left = 0.1;  // [m/s]
  double turn = 0.8;                                  // [rad/s]
};

/// A pose relative to the robot.
struct Destination {
  double x = 0, y = 0;  // [m, robot]
  double heading = 0;   // [rad, robot] on arrival
};

/// Returns the command, shortened to the limits: an ellipse of forward and sideward speed, which shrinks while the robot
/// turns.
Command within(const Limits& limits, const Command& command);

/// Returns the command that leads to the destination with the share `gain` [0..1] of the greatest speed. A far one is
/// walked to ahead, a near one in any direction. Returns zero on arrival: within 4 cm and 0.2 rad.
Command towards(const Destination& destination, double gain, const Limits& limits);

}  // namespace robot::nao::walk
