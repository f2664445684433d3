#include "robot/lab/clocks/lag_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robot::lab {
namespace {

constexpr double kLeastSlope = 0.3, kMostSlope = 3;  // [-] others are accidents

/// The points of a distance at one lag.
struct Points {
  std::vector<LinePoint> points;
  std::vector<double> times;  // [s] of the points, by the robot's clock

  Points(const SharedDistance& distance, double lag) {
    for (const Sample& sample : distance.seen)
      if (const auto point = distance.point(sample, lag)) {
        points.push_back(*point);
        times.push_back(sample.at);
      }
  }
};

/// Returns the distance with the values that have a truth at every lag.
SharedDistance seen_everywhere(SharedDistance distance, const Lags& lags) {
  std::erase_if(distance.seen, [&](const Sample& sample) {
    for (std::size_t i = 0; i < lags.count; ++i)
      if (!distance.truth->at(sample.at - lags.at(i))) return true;
    return false;
  });
  return distance;
}

double median_distance(const Series& seen) {
  std::vector<double> values;
  values.reserve(seen.size());
  for (const Sample& sample : seen) values.push_back(sample.value);
  return median_of(std::move(values));
}

}  // namespace

Lags Lags::around(double middle, double reach, double step) {
  const double each_side = std::ceil(reach / step - 1e-9);
  return {.first = middle - each_side * step, .step = step, .count = 2 * static_cast<std::size_t>(each_side) + 1};
}

Cells::Cells(const Series& series, double length, std::size_t most) {
  std::vector<double> starts;
  for (const Sample& sample : series)
    if (starts.empty() || sample.at >= starts.back() + length) starts.push_back(sample.at);
  const std::size_t joined = std::max<std::size_t>(1, (starts.size() + most - 1) / most);
  for (std::size_t i = 0; i < starts.size(); i += joined) starts_.push_back(starts[i]);
}

std::size_t Cells::of(double at) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(starts_, at) - starts_.begin()) - 1;
}

LagProfile::LagProfile(const SharedDistance& distance, const Lags& lags, Cells cells, Everywhere everywhere)
    : lags_(lags), cells_(std::move(cells)), sums_(lags_.count * cells_.count()) {
  add(everywhere == Everywhere::yes ? seen_everywhere(distance, lags_) : distance);
}

void LagProfile::add(const SharedDistance& distance) {
  const Line constant{.bias = median_distance(distance.seen), .slope = 0};
  Line line{.bias = 0, .slope = 1};
  for (std::size_t lag = 0; lag < lags_.count; ++lag) {
    const Points at_lag(distance, lags_.at(lag));
    values_ = std::max(values_, at_lag.points.size());
    line = fitted(at_lag.points, line);  // neighbours have similar lines
    for (std::size_t i = 0; i < at_lag.points.size(); ++i) {
      LossSums& sums = sums_[lag * cells_.count() + cells_.of(at_lag.times[i])];
      sums.add(at_lag.points[i], line);
      sums.constant -= loss(constant.residual(at_lag.points[i]));
    }
  }
}

std::vector<double> LagProfile::gains(const std::vector<double>& times) const {
  std::vector<double> gains(lags_.count, 0);
  for (std::size_t lag = 0; lag < lags_.count; ++lag) {
    LossSums sums;
    for (std::size_t cell = 0; cell < cells_.count(); ++cell)
      if (times[cell] > 0) sums.add(sums_[lag * cells_.count() + cell], times[cell]);
    const Line line = sums.best();
    if (line.slope >= kLeastSlope && line.slope <= kMostSlope) gains[lag] = -sums.loss_of(line);
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
