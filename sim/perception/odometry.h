// Prediction by odometry: the robot's own motion moves what it believes. The odometry has hidden errors.
#pragma once

#include <span>

#include "sim/perception/look.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// Predicts the believed balls and poses of all lookers from their odometry, and moves `cognition.last` to the present
/// pose. Many short predictions end where one long one does.
///
/// The error of the odometry is not added to the ball's uncertainty. It is 1 cm, 5 % of the 0.2 m that a robot walks in a
/// second, while an unseen ball becomes uncertain by some tenths of a metre.
void predict(const PerceptionParams& params, std::span<const Look> looks);

}  // namespace sim::perception
