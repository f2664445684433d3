// The errors of the marks that explain how wrong the poses are.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/fit/localisation/mark_walk.h"
#include "robot/fit/localisation/variance_parts.h"

namespace robot::fit {

/// A figure of the models, and one standard deviation of it.
struct UncertainFigure {
  float sim::perception::Localisation::*figure = nullptr;
  double deviation = 0;
};

struct MarkFit {
  RootInterval place, heading;           // mark_deviation [m], mark_deviation_heading [rad]
  std::string place_kept, heading_kept;  // reasons why they stay; empty: fitted
  MarkErrors recorded, fitted, before;   // errors of the record, and as simulated with the fit and with `models`
  std::size_t blocks = 0;                // of half a minute
};

/// Finds the deviations with which the simulator's localisation makes the recorded errors on the same walks: the method of simulated
/// moments. `models` hold the fitted odometry, and `uncertain` its errors, which widen the interval. A deviation is not fitted if
/// the errors hardly depend on it. Returns an Error with fewer than twenty half minutes.
Result<MarkFit> fit_marks(const std::vector<MarkWalk>& walks, const sim::Models& models, const sim::field::Field& field,
                          const std::vector<UncertainFigure>& uncertain);

/// The field of the Standard Platform League since 2020 (sim/data/rules/spl2025.json).
inline constexpr sim::field::Field kFieldOfTheLeague{.length = 9,
                                                     .width = 6,
                                                     .border = 0.7f,
                                                     .line_width = 0.05f,
                                                     .centre_circle_radius = 0.75f,
                                                     .goal_area_length = 0.6f,
                                                     .goal_area_width = 2.2f,
                                                     .penalty_area_length = 1.65f,
                                                     .penalty_area_width = 4,
                                                     .penalty_mark = 1.3f,
                                                     .goal_width = 1.6f,
                                                     .goal_depth = 0.5f,
                                                     .post_radius = 0.05f};

}  // namespace robot::fit
