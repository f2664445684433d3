#include "robot/lab/clocks/shared_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace robot::lab {

std::optional<LinePoint> SharedDistance::point(const Sample& sample, double lag) const {
  constexpr double kGrowsFrom = 0.5;  // [m] closer by, the noise hardly shrinks
  const auto true_value = truth->at(sample.at - lag);
  if (!true_value) return std::nullopt;
  const double one = 1 / (deviation * std::hypot(1, sample.value / kGrowsFrom));
  return LinePoint{.one = one, .x = *true_value * one, .value = sample.value * one};
}

SharedDistance with_measured_noise(SharedDistance distance, double lag) {
  std::vector<LinePoint> points;
  for (const Sample& sample : distance.seen)
    if (const auto point = distance.point(sample, lag)) points.push_back(*point);
  const Line line = fitted(points);
  std::vector<double> residuals;
  for (const LinePoint& point : points) residuals.push_back(std::abs(line.residual(point)));
  constexpr double kOfNormal = 1.4826;  // standard deviation / median size of normal values
  constexpr double kLeast = 1e-3;       // [m] exact distances, as of a simulation, have a noise as well
  distance.deviation = std::max(kLeast, distance.deviation * kOfNormal * median_of(std::move(residuals)));
  return distance;
}

}  // namespace robot::lab
