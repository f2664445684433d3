// A quantity that the ground truth and a robot both measured.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "robot/lab/clocks/robust_line.h"
#include "robot/lab/clocks/series.h"

namespace robot::lab {

/// A quantity of both sides, as the robot reports it: bias + slope * truth + noise.
struct SharedQuantity {
  std::shared_ptr<const SmoothCurve> truth;
  Series robot;                              // tidied; its clock is ahead by an unknown lag
  double least_slope = 0.3, most_slope = 3;  // [-] others are accidents

  /// The noise is proportional to hypot(1, value / `grows_from`), as that of a distance is. 0: the same for all values.
  double grows_from = 0;

  /// Standard deviation of the noise of a small value, in its unit. A rough one does for a search.
  double deviation = 0.1;

  /// Returns the point of a line fit, in standard deviations of its noise, when the robot's clock is ahead by `lag` [s].
  /// Returns nothing without a truth.
  std::optional<LinePoint> point(const Sample& seen, double lag) const;
};

/// Returns the quantity with the deviation that its values have when the robot's clock is ahead by `lag` [s].
SharedQuantity with_measured_deviation(SharedQuantity quantity, double lag);

}  // namespace robot::lab
