// The error that a calibration leaves in measured places, all over the field.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "robot/truth/calibration/view.h"

namespace robot::truth {

/// The expected distance between a measured place and the true one, from the calibration alone.
struct ErrorAt {
  double x = 0, y = 0;  // [m, field]
  double metres = 0;
};

/// Errors of the places that the sensor sees, in a grid of 0.5 m. All zero and empty: it sees none of the field.
struct ExpectedError {
  double mean = 0, p95 = 0;  // [m] over all places of the grid
  std::vector<ErrorAt> grid;
};

/// The way to measure a place: a point's depth, or its bearing and its known height.
enum class MeasuredBy { depth, bearing };

/// The farthest depth [m] that counts for MeasuredBy::depth. Beyond it the noise of a depth is greater than any error of a
/// calibration.
inline constexpr double kFarthestDepth = 5;

/// Returns the expected error of points at this height [m], for |x| <= reach.x and |y| <= reach.y [m, field].
ExpectedError expected_error(const View& view, const ViewCovariance& covariance, const Eigen::Vector2d& reach,
                             MeasuredBy measurement, double height);

/// Returns the covariance [m²] of a measured place, as the calibration's error moves it. Returns nothing where the sensor
/// cannot measure it.
std::optional<Eigen::Matrix2d> place_covariance(const View& view, const ViewCovariance& covariance,
                                                const Eigen::Vector3d& point, MeasuredBy measurement);

}  // namespace robot::truth
