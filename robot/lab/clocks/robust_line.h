// A straight line through points with outliers, and the sums from which it follows.
#pragma once

#include <vector>

namespace robot::lab {

/// A point of a line fit, in standard deviations of its noise: value = bias * one + slope * x.
struct LinePoint {
  double one = 1, x = 0, value = 0;
};

struct Line {
  double bias = 0, slope = 0;
  double residual(const LinePoint& point) const { return point.value - bias * point.one - slope * point.x; }
};

/// Cauchy's loss of a residual in standard deviations. It grows like half the square for small ones, and slowly for
/// outliers.
double loss(double residual);

/// The loss of many points for every line near one: a parabola in bias and slope that touches the loss there. Sums of points
/// can be added, so that parts of a recording are weighed anew without a look at their points.
struct LossSums {
  double constant = 0, one_one = 0, one_x = 0, x_x = 0, one_value = 0, x_value = 0, value_value = 0;

  /// Adds a point, for lines near `line`.
  void add(const LinePoint& point, const Line& line);

  /// Adds `times` times the sums of others.
  void add(const LossSums& others, double times);

  /// Returns the line of the least loss. The slope is 0 if the points do not determine it.
  Line best() const;
  double loss_of(const Line& line) const;
};

/// Returns the line of the least loss through the points, approached from `start`.
Line fitted(const std::vector<LinePoint>& points, Line start = {.bias = 0, .slope = 1});

}  // namespace robot::lab
