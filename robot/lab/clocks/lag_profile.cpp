#include "robot/lab/clocks/lag_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robot::lab {
namespace {

/// The points of a quantity at one lag.
struct Points {
  std::vector<LinePoint> points;
  std::vector<std::size_t> samples;  // the index of each point's value

  Points(const SharedQuantity& quantity, double lag) {
    for (std::size_t i = 0; i < quantity.robot.size(); ++i)
      if (const auto point = quantity.point(quantity.robot[i], lag)) {
        points.push_back(*point);
        samples.push_back(i);
      }
  }
};

/// Returns the quantity with the values that have a truth at every lag.
SharedQuantity seen_everywhere(SharedQuantity quantity, const Lags& lags) {
  std::erase_if(quantity.robot, [&](const Sample& seen) {
    for (std::size_t i = 0; i < lags.count; ++i)
      if (!quantity.truth->at(seen.at - lags.at(i))) return true;
    return false;
  });
  return quantity;
}

/// Returns the value that explains all values best without a truth.
double constant_of(const SharedQuantity& quantity) {
  if (quantity.robot.empty()) return 0;
  std::vector<double> values;
  for (const Sample& seen : quantity.robot) values.push_back(seen.value);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

Lags Lags::around(double middle, double reach, double step) {
  const double each_side = std::ceil(reach / step - 1e-9);
  return {.first = middle - each_side * step, .step = step, .count = 2 * static_cast<std::size_t>(each_side) + 1};
}

std::size_t Cells::of(double at) const {
  return static_cast<std::size_t>(std::clamp((at - start) / length, 0.0, static_cast<double>(count - 1)));
}

void LagProfile::add(const SharedQuantity& given, bool everywhere) {
  const SharedQuantity quantity = everywhere ? seen_everywhere(given, lags_) : given;
  const Line constant{.bias = constant_of(quantity), .slope = 0};
  Table table{.least_slope = quantity.least_slope,
              .most_slope = quantity.most_slope,
              .sums = std::vector<LossSums>(lags_.count * cells_.count)};
  Line line{.bias = 0, .slope = 1};
  for (std::size_t lag = 0; lag < lags_.count; ++lag) {
    const Points at_lag(quantity, lags_.at(lag));
    values_[lag] += at_lag.points.size();
    line = fitted(at_lag.points, line);
    for (std::size_t i = 0; i < at_lag.points.size(); ++i) {
      LossSums& sums = table.sums[lag * cells_.count + cells_.of(quantity.robot[at_lag.samples[i]].at)];
      sums.add(at_lag.points[i], line);
      sums.constant -= loss(constant.residual(at_lag.points[i]));
    }
  }
  tables_.push_back(std::move(table));
}

std::vector<double> LagProfile::gains(const std::vector<double>& times) const {
  std::vector<double> gains(lags_.count, 0);
  for (const Table& table : tables_)
    for (std::size_t lag = 0; lag < lags_.count; ++lag) {
      LossSums sums;
      for (std::size_t cell = 0; cell < cells_.count; ++cell)
        if (times[cell] > 0) sums.add(table.sums[lag * cells_.count + cell], times[cell]);
      const Line line = sums.best();
      if (line.slope >= table.least_slope && line.slope <= table.most_slope) gains[lag] -= sums.loss_of(line);
    }
  return gains;
}

std::optional<double> best_lag(const Lags& lags, const std::vector<double>& gains) {
  const auto best = std::ranges::max_element(gains);
  if (best == gains.end() || *best <= 0) return std::nullopt;
  const auto place = static_cast<std::size_t>(best - gains.begin());
  if (place == 0 || place + 1 == gains.size()) return std::nullopt;
  // the parabola through the best lag and its neighbours
  const double before = gains[place - 1], after = gains[place + 1], bend = before - 2 * *best + after;
  const double part = bend < 0 ? std::clamp((before - after) / (2 * bend), -0.5, 0.5) : 0;
  return lags.at(place) + part * lags.step;
}

}  // namespace robot::lab
