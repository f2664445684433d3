#include "robot/fit/walking/paces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace robot::fit {
namespace {

constexpr std::size_t kPacePoints = 400, kSpreadPoints = 91;
constexpr double kWidestSpread = 0.9;     // as in the models
constexpr double kExactPace = 0.002;      // deviation of a pace that is known exactly
constexpr double kLikelihoodDrop = 1.92;  // of a 95 % interval of one parameter

double normal_share_below(double x) { return std::erfc(-x / std::sqrt(2.)) / 2; }

/// Returns the logarithm of the density of the paces.
double paces_likelihood(const Vector& paces, const Vector& deviations, double fastest, double spread) {
  double sum = 0;
  for (std::size_t i = 0; i < paces.size(); ++i) {
    const double deviation = deviations[i], slowest = fastest * (1 - spread);
    const double density = fastest - slowest > 0.1 * deviation
                               ? (normal_share_below((fastest - paces[i]) / deviation) -
                                  normal_share_below((slowest - paces[i]) / deviation)) /
                                     (fastest - slowest)
                               : std::exp(-std::pow((fastest - paces[i]) / deviation, 2) / 2) / (deviation * 2.5066);
    sum += std::log(std::max(1e-300, density));
  }
  return sum;
}

/// Returns the median and the quantiles of a distribution on equal distances.
Likely grid_quantiles_of(const Vector& weights, double from, double to) {
  double total = 0, below = 0;
  for (const double weight : weights) total += weight;
  Likely likely{from, from, to};
  const double step = (to - from) / static_cast<double>(std::max<std::size_t>(2, weights.size()) - 1);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double above = below + weights[i] / total;
    const auto passes = [&](double share) { return below < share && above >= share; };
    const auto place = [&](double share) {
      return from + step * (static_cast<double>(i) - 0.5 + (share - below) / (above - below));
    };
    if (passes(0.025)) likely.low = place(0.025);
    if (passes(0.5)) likely.value = place(0.5);
    if (passes(0.975)) likely.high = place(0.975);
    below = above;
  }
  return likely;
}

}  // namespace

Fastest fastest_of(const Vector& log_paces, const Vector& deviations, std::optional<double> spread) {
  // in shares of the fastest recorded robot
  const double top = *std::ranges::max_element(log_paces);
  Vector paces, errors;
  double mean_error = 0;
  for (std::size_t i = 0; i < log_paces.size(); ++i) {
    paces.push_back(std::exp(log_paces[i] - top));
    errors.push_back(paces.back() * std::max(kExactPace, deviations[i]));
    mean_error += errors.back() / static_cast<double>(log_paces.size());
  }
  const double most_error = *std::ranges::max_element(errors);
  const double from = -std::min(1., 6 * most_error);
  const double to = 6 * most_error - std::log(1 - spread.value_or(kWidestSpread));
  const std::size_t spreads = spread ? 1 : kSpreadPoints;
  const auto spread_at = [&](std::size_t k) {
    return spread ? *spread : kWidestSpread * static_cast<double>(k) / (kSpreadPoints - 1);
  };
  // the posterior on a grid; the prior of ends of a uniform distribution is one over its width
  std::vector<Vector> logs(spreads, Vector(kPacePoints));
  Vector best(spreads, -INFINITY);
  double highest = -INFINITY;
  for (std::size_t k = 0; k < spreads; ++k)
    for (std::size_t i = 0; i < kPacePoints; ++i) {
      const double log_fastest = from + (to - from) * static_cast<double>(i) / (kPacePoints - 1);
      const double likelihood = paces_likelihood(paces, errors, std::exp(log_fastest), spread_at(k));
      best[k] = std::max(best[k], likelihood);
      logs[k][i] = likelihood + (spread ? 0 : log_fastest - std::log(spread_at(k) + mean_error));
      highest = std::max(highest, logs[k][i]);
    }
  Vector by_pace(kPacePoints), by_spread(spreads);
  for (std::size_t k = 0; k < spreads; ++k)
    for (std::size_t i = 0; i < kPacePoints; ++i) {
      const double weight = std::exp(logs[k][i] - highest);
      by_pace[i] += weight, by_spread[k] += weight;
    }
  Fastest fastest{.log_pace = grid_quantiles_of(by_pace, from, to), .spread = {}};
  fastest.log_pace.value += top, fastest.log_pace.low += top, fastest.log_pace.high += top;
  if (spread) {
    fastest.spread = {*spread, *spread, *spread};
    return fastest;
  }
  fastest.spread = grid_quantiles_of(by_spread, 0, kWidestSpread);
  // robots may all be alike
  if (best.front() > *std::ranges::max_element(best) - kLikelihoodDrop) fastest.spread.low = 0;
  fastest.spread.low = std::max(0., fastest.spread.low);
  return fastest;
}

}  // namespace robot::fit
