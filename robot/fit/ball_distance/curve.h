// Curves from the ball's radius in the image to its distance.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "robot/fit/ball_distance/sizes.h"
#include "robot/fit/math/least_squares.h"

namespace robot::fit {

enum class CurveKind {
  constant,   // d = p0: what one says without looking
  power_law,  // d = p0 r^p1, as the thesis of 2012 has it
  pinhole,    // d = sqrt((p0 / (r - p1))² - p2²): a pinhole, p2 above the middle of the ball, with blurred edges
};

/// Names for tables: "constant", "power law", "pinhole".
std::string_view name_of(CurveKind kind);

/// The deviation of a radius in images: a part that all have, and a part that grows with it.
struct RadiusNoise {
  double base = 0.5;  // [px]
  double share = 0;

  double of(double radius) const;
};

struct Curve {
  CurveKind kind = CurveKind::constant;
  Vector parameters;       // [m, or m px; 1, or px; m]
  RadiusNoise noise = {};  // of the pinhole

  /// Returns the distance [m] along the ground for a radius [px, see BallSize], 0 where the pinhole has none because the ball
  /// would be nearer than below the camera. That of the pinhole is right on average over the noise of radii: a radius that is
  /// too small by chance errs by more than one that is too large.
  double distance(double radius) const;
};

/// Fits a curve to some of the observations, which may repeat; at least one. The power law is the straight line through
/// logarithms. The pinhole treats both errors as such: the residual of a radius is divided by its own deviation and by
/// that of the true distance. Single bad radii hardly count (Loss::cauchy).
Curve fit_curve(CurveKind kind, const std::vector<BallSize>& sizes, const std::vector<std::size_t>& chosen);

}  // namespace robot::fit
