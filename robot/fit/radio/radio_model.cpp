#include "robot/fit/radio/radio_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/fit/math/counts.h"
#include "robot/fit/math/resampling.h"

namespace robot::fit {
namespace {

constexpr double kLeastMean = 1e-4;  // [s] packets are not faster
constexpr int kDelaySteps = 60;

/// Returns the mean of delays that are cut at five means.
double cut_mean(const std::vector<std::vector<double>>& delays, double most) {
  double sum = 0;
  std::size_t count = 0;
  for (const std::vector<double>& packet : delays) {
    for (const double delay : packet) sum += std::min(delay, most);
    count += packet.size();
  }
  return sum / static_cast<double>(count);
}

/// Returns one standard deviation of the mean of all values, by the scatter of the groups.
double deviation_of_mean(const std::vector<Shared>& groups) {
  double sum = 0, count = 0, squares = 0;
  for (const Shared& group : groups) sum += group.sum, count += static_cast<double>(group.count);
  const double mean = sum / count;
  for (const Shared& group : groups) squares += std::pow(group.sum - mean * static_cast<double>(group.count), 2);
  const auto n = static_cast<double>(groups.size());
  return std::sqrt(squares * n / (n - 1)) / count;
}

}  // namespace

double mean_delay(double mean, double step) {
  if (!(mean > 0)) return 0;
  if (step <= 0) return mean * (1 - std::exp(-kLongestDelayInMeans));
  // the sum of the chances of k steps or more
  double sum = 0;
  for (double edge = step / 2; edge <= kLongestDelayInMeans * mean; edge += step) sum += std::exp(-edge / mean);
  return step * sum;
}

Bounded fit_delay(const std::vector<std::vector<double>>& delays, double step, double clock) {
  double mean = std::max(kLeastMean, cut_mean(delays, INFINITY));
  for (int i = 0; i < kDelaySteps; ++i) {
    const double observed = cut_mean(delays, kLongestDelayInMeans * mean + step / 2);
    const double expected = mean_delay(mean, step);
    const double next =
        std::max(kLeastMean, expected > 0 ? mean * std::clamp(observed / expected, 0.2, 2.) : 1.1 * mean);
    if (std::abs(std::exchange(mean, next) - next) < 1e-9) break;
  }
  std::vector<Shared> packets;
  for (const std::vector<double>& packet : delays) {
    if (packet.empty()) continue;
    packets.push_back({.sum = 0, .count = packet.size()});
    for (const double delay : packet) packets.back().sum += std::min(delay, kLongestDelayInMeans * mean + step / 2);
  }
  const double slope = (mean_delay(1.1 * mean, step) - mean_delay(0.9 * mean, step)) / (0.2 * mean);
  const double luck = deviation_of_mean(packets) / std::max(0.1, slope);
  // the luck of a mean is even in its logarithm, that of the clocks is not
  const double share = std::exp(two_sided(packets.size() - 1) * luck / mean);
  const double clocks = two_sided(packets.size() - 1) * clock;
  return {.value = mean,
          .low = std::max(0., mean - std::hypot(mean - mean / share, clocks)),
          .high = mean + std::hypot(mean * share - mean, clocks)};
}

Bounded fit_share(const std::vector<Shared>& groups) {
  double hits = 0, cases = 0;
  for (const Shared& group : groups) hits += group.sum, cases += static_cast<double>(group.count);
  const double share = hits / cases;
  const double deviation = deviation_of_mean(groups);
  // without a single hit or miss nothing shows the luck of groups: each counts as one observation
  double n = share > 0 && share < 1 ? cases : static_cast<double>(groups.size());
  if (deviation > 0) n = std::min(n, share * (1 - share) / (deviation * deviation));
  const double z = two_sided(std::max<std::size_t>(2, groups.size() - 1));
  const CountInterval interval = wilson_interval(share, n, z);
  return {.value = share, .low = interval.low, .high = interval.high};
}

double delay_score(double mean, double seconds) {
  if (seconds < 0) return mean / 2 - seconds;
  return seconds + 2 * mean * std::exp(-seconds / mean) - 1.5 * mean;
}

}  // namespace robot::fit
