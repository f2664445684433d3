// The errors of odometry as the simulator has them, fitted to windows of walks. Pure.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/fit/localisation/drift.h"
#include "robot/fit/localisation/variance_parts.h"

namespace robot::fit {

/// The model of the errors (sim/perception/model.h).
struct OdometryModel {
  double bias = 0;                // standard deviation of the scales over robots
  double translation_noise = 0;   // [m^0.5]
  double rotation_noise = 0;      // [rad^0.5]
  double rotation_per_metre = 0;  // [rad/m^0.5]
  double place_error = 0;         // [m] of a window's displacement by the truth alone, each axis
  double heading_error = 0;       // [rad] likewise of its turn

  /// Returns the variance of a window's error [m²], each axis, beside a known scale.
  double place_variance(const DriftWindow& window) const;
  double heading_variance(const DriftWindow& window) const;  // [rad²]
};

/// A scale of one robot in one game: believed / true.
struct OdometryScale {
  double value = 1;
  double deviation = INFINITY;  // one standard deviation of its estimate

  bool is_known() const { return deviation < 0.1; }
};

struct OdometryFit {
  OdometryModel model;
  std::vector<OdometryScale> walking, turning;  // by recording
  VarianceParts place, heading;                 // factors of way, constant; of turned, way, constant
};

/// Fits the model to windows of `recordings` recordings by the greatest likelihood. The error of the truth is a constant part of
/// each variance, so it biases nothing. Single bad windows hardly count. A bias needs six known scales; otherwise it is NaN.
OdometryFit fit_drift(const std::vector<DriftWindow>& windows, std::size_t recordings);

/// Returns the errors of places and of headings beside the fitted scales.
std::vector<SquaredError> place_errors(const std::vector<DriftWindow>& windows,
                                       const std::vector<OdometryScale>& walking);
std::vector<SquaredError> heading_errors(const std::vector<DriftWindow>& windows,
                                         const std::vector<OdometryScale>& turning);

/// Returns the standard deviation of all known scales around 1 beyond their own errors, with its interval. At least six are known.
RootInterval bias_interval(const OdometryFit& fit);
std::size_t known_scales(const OdometryFit& fit);
inline constexpr std::size_t kFewestScales = 6;

}  // namespace robot::fit
