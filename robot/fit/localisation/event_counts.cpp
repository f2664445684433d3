#include "robot/fit/localisation/event_counts.h"

#include <cmath>

namespace robot::fit {
namespace {

constexpr double kTail = 0.025;

/// Returns the probability of at most `count` events of a Poisson distribution.
double at_most(std::size_t count, double mean) {
  double term = std::exp(-mean), sum = term;
  for (std::size_t i = 1; i <= count; ++i) sum += term *= mean / static_cast<double>(i);
  return sum;
}

/// Returns the mean at which at most `count` events have a probability.
double mean_with(std::size_t count, double probability) {
  const auto events = static_cast<double>(count);
  double low = 0, high = events + 10 * std::sqrt(events + 1) + 10;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (at_most(count, middle) > probability ? low : high) = middle;
  }
  return low;
}

}  // namespace

CountInterval mean_count(std::size_t count) {
  constexpr std::size_t kMany = 300;
  if (count > kMany) {
    const auto events = static_cast<double>(count);
    return {.value = events, .low = events - 1.96 * std::sqrt(events), .high = events + 1.96 * std::sqrt(events)};
  }
  return {.value = static_cast<double>(count),
          .low = count == 0 ? 0 : mean_with(count - 1, 1 - kTail),
          .high = mean_with(count, kTail)};
}

CountInterval mean_duration(std::size_t ended, double total) {
  const CountInterval count = mean_count(ended);
  return {.value = total / count.value, .low = total / count.high, .high = total / count.low};
}

}  // namespace robot::fit
