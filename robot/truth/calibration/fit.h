// The fit of a sensor's view to clicked landmarks and the carpet.
#pragma once

#include <optional>
#include <vector>

#include "robot/truth/calibration/ground.h"
#include "robot/truth/calibration/view.h"

namespace robot::truth {

/// A landmark and its pixel.
struct Sighting {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // [m, field]
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double deviation = 1;  // [px] of each coordinate
};

/// Returns the distance [px] in the picture between the sighting's pixel and its landmark. Far for a landmark behind the
/// sensor.
double miss_of(const View& view, const Sighting& sighting);

/// The knowledge before the fit: a camera and one standard deviation of each uncertain number. 0: known exactly.
struct Prior {
  Projection camera;
  double depth_scale_deviation = 0;  // around 1
  double focal_deviation = 0;        // as a share of the focal length
  double k1_deviation = 0;
};

/// The cost of a landmark's miss. Squares give the exact covariance; Cauchy's loss lets single wrong clicks pull little.
enum class Loss { squares, cauchy };

struct Fit {
  View view;
  ViewCovariance covariance = ViewCovariance::Zero();
};

/// Returns the view with the least cost that a descent from `start` reaches. The cost contains the misses of the landmarks,
/// the distances of the carpet's pixels from z = 0, and the prior, each by its deviation.
Fit fit_view(const View& start, const std::vector<Sighting>& sightings, const std::optional<Ground>& ground,
             const Prior& prior, Loss loss);

}  // namespace robot::truth
