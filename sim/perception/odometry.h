// Prediction by odometry: the robot's own motion moves what it believes. The odometry has hidden errors.
#pragma once

#include <span>

#include "sim/perception/look.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// The believed motion since the last reading. [robot, present pose]
struct Odometry {
  Vec2 moved;        // [m]
  float way = 0;     // [m] length of `moved`
  float turned = 0;  // [rad]
  Vec2 turn{1, 0};   // unit vector at `turned`
};

/// Predicts the believed balls and poses of all lookers from their odometry, and moves `cognition.last` to the present
/// pose. Many short predictions end where one long one does.
///
/// The error of the odometry is not added to the ball's uncertainty. It is 1 cm, 5 % of the 0.2 m that a robot walks in a
/// second, while an unseen ball becomes uncertain by some tenths of a metre.
void predict(const PerceptionParams& params, std::span<const Look> looks);

}  // namespace sim::perception
