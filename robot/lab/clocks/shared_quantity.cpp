#include "robot/lab/clocks/shared_quantity.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robot::lab {

std::optional<LinePoint> SharedQuantity::point(const Sample& seen, double lag) const {
  const auto true_value = truth->at(seen.at - lag);
  if (!true_value) return std::nullopt;
  const double one = 1 / (deviation * (grows_from > 0 ? std::hypot(1, seen.value / grows_from) : 1));
  return LinePoint{.one = one, .x = *true_value * one, .value = seen.value * one};
}

SharedQuantity with_measured_deviation(SharedQuantity quantity, double lag) {
  std::vector<LinePoint> points;
  for (const Sample& seen : quantity.robot)
    if (const auto point = quantity.point(seen, lag)) points.push_back(*point);
  if (points.empty()) return quantity;
  const Line line = fitted(points);
  std::vector<double> sizes;
  for (const LinePoint& point : points) sizes.push_back(std::abs(line.residual(point)));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  constexpr double kOfNormal = 1.4826;  // standard deviation / median size of normal values
  constexpr double kLeast = 1e-3;       // exact values, as of a simulation, have a noise as well
  quantity.deviation = std::max(kLeast, quantity.deviation * kOfNormal * *middle);
  return quantity;
}

}  // namespace robot::lab
