// The distance between a robot and the ball, as the ground truth and the robot measured it.
#pragma once

#include <memory>
#include <optional>

#include "robot/lab/clocks/robust_line.h"
#include "robot/lab/clocks/series.h"

namespace robot::lab {

/// The distance between a robot and the ball. The robot sees bias + slope * truth + noise. The noise grows with the distance.
struct SharedDistance {
  std::shared_ptr<const SmoothCurve> truth;  // [m]
  Series seen;                               // [m] by the robot, tidied; its clock is ahead by an unknown lag
  double deviation = 0.1;                    // [m] of the noise of a small distance; a search needs a rough one only

  /// Returns the point of a line fit, in standard deviations of its noise, when the robot's clock is ahead by `lag` [s].
  /// Returns nothing without a truth.
  std::optional<LinePoint> point(const Sample& sample, double lag) const;
};

/// Returns the distance with the deviation that its noise has when the robot's clock is ahead by `lag` [s].
SharedDistance with_measured_noise(SharedDistance distance, double lag);

}  // namespace robot::lab
