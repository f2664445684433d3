#include "robot/fit/visibility/poisson.h"

#include <cmath>

namespace robot::fit {
namespace {

constexpr double kTail = 0.025;
constexpr int kHalvings = 80;

/// Returns the probability of at most `events`.
double at_most(std::size_t events, double mean) {
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
  double low = 0, high = n + 10 * std::sqrt(n + 1) + 10;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (at_most(events, middle) > probability ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

MeanInterval poisson_interval(std::size_t events) {
  return {.low = events == 0 ? 0 : mean_with(events - 1, 1 - kTail), .high = mean_with(events, kTail)};
}

}  // namespace robot::fit
