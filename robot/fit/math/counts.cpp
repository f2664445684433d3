#include "robot/fit/math/counts.h"

#include <algorithm>
#include <cmath>

namespace robot::fit {
namespace {

constexpr double kTail = 0.025;
constexpr int kHalvings = 100;

/// Returns the place between `low` and `high` where `is_below` changes from true to false.
template <class Below>
double border(double low, double high, Below&& is_below) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (is_below(middle) ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Returns the probability of at most `events` of a Poisson distribution.
double poisson_at_most(std::size_t events, double mean) {
  double logarithm = -mean, sum = std::exp(logarithm);  // of one term, of all
  for (std::size_t k = 1; k <= events; ++k) {
    logarithm += std::log(mean / static_cast<double>(k));
    sum += std::exp(logarithm);
  }
  return sum;
}

/// Returns the mean that gives at most `events` with this probability.
double mean_with(std::size_t events, double probability) {
  const auto n = static_cast<double>(events);
  return border(0, n + 10 * std::sqrt(n + 1) + 10,
                [&](double mean) { return poisson_at_most(events, mean) > probability; });
}

/// Returns n log(x), also 0 log(0).
double times_log(double n, double x) { return n == 0 ? 0 : n * std::log(x); }

/// Returns the probability of at least `hits` of `cases`.
double binomial_at_least(std::size_t hits, std::size_t cases, double share) {
  double sum = 0;
  const auto n = static_cast<double>(cases);
  for (std::size_t i = hits; i <= cases; ++i) {
    const auto k = static_cast<double>(i);
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) + times_log(k, share) +
                    times_log(n - k, 1 - share));
  }
  return sum;
}

}  // namespace

CountInterval poisson_interval(std::size_t events) {
  return {.low = events == 0 ? 0 : mean_with(events - 1, 1 - kTail), .high = mean_with(events, kTail)};
}

MeanDuration mean_duration(std::size_t ended, double total) {
  const CountInterval count = poisson_interval(ended);
  return {.value = total / static_cast<double>(ended), .low = total / count.high, .high = total / count.low};
}

CountInterval exact_share(std::size_t hits, std::size_t cases) {
  CountInterval interval{.low = 0, .high = 1};
  if (hits > 0)
    interval.low = border(0, 1, [&](double share) { return binomial_at_least(hits, cases, share) < kTail; });
  if (hits < cases)
    interval.high = border(0, 1, [&](double share) { return binomial_at_least(hits + 1, cases, share) < 1 - kTail; });
  return interval;
}

CountInterval wilson_interval(double share, double cases, double deviations) {
  const double square = deviations * deviations / cases, middle = (share + square / 2) / (1 + square);
  const double half = deviations / (1 + square) * std::sqrt(share * (1 - share) / cases + square / (4 * cases));
  // at the ends the formula leaves a rest of rounding
  return {.low = share > 0 ? std::max(0., middle - half) : 0, .high = share < 1 ? std::min(1., middle + half) : 1};
}

}  // namespace robot::fit
