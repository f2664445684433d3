#include "robot/lab/clocks/robust_line.h"

#include <cmath>

namespace robot::lab {
namespace {

/// Square of the residual [standard deviations] beyond which a point counts less and less.
constexpr double kSquare = 2 * 2;

/// Returns the weight of a residual in a fit of least squares that approaches the loss.
double weight_of(double residual) { return kSquare / (kSquare + residual * residual); }

}  // namespace

double loss(double residual) { return kSquare / 2 * std::log1p(residual * residual / kSquare); }

void LossSums::add(const LinePoint& point, const Line& line) {
  const double residual = line.residual(point), weight = weight_of(residual);
  constant += loss(residual) - weight * residual * residual / 2;
  one_one += weight * point.one * point.one;
  one_x += weight * point.one * point.x;
  x_x += weight * point.x * point.x;
  one_value += weight * point.one * point.value;
  x_value += weight * point.x * point.value;
  value_value += weight * point.value * point.value;
}

void LossSums::add(const LossSums& others, double times) {
  constant += times * others.constant;
  one_one += times * others.one_one;
  one_x += times * others.one_x;
  x_x += times * others.x_x;
  one_value += times * others.one_value;
  x_value += times * others.x_value;
  value_value += times * others.value_value;
}

Line LossSums::best() const {
  const double determinant = one_one * x_x - one_x * one_x;
  if (!(determinant > 1e-9 * one_one * x_x)) return {.bias = one_one > 0 ? one_value / one_one : 0, .slope = 0};
  return {.bias = (one_value * x_x - x_value * one_x) / determinant,
          .slope = (x_value * one_one - one_value * one_x) / determinant};
}

double LossSums::loss_of(const Line& line) const {
  const auto& [bias, slope] = line;
  return constant + (value_value + bias * bias * one_one + slope * slope * x_x) / 2 + bias * slope * one_x -
         bias * one_value - slope * x_value;
}

Line fitted(const std::vector<LinePoint>& points, Line start) {
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    LossSums sums;
    for (const LinePoint& point : points) sums.add(point, start);
    start = sums.best();
  }
  return start;
}

}  // namespace robot::lab
