#include "robot/lab/clocks/data_offset.h"

#include <algorithm>

namespace robot::lab {
namespace {

constexpr double kPart = 120;            // [s]
constexpr double kPartDeviation = 0.06;  // [s] parts with a larger one do not count
constexpr std::size_t kLeastParts = 3;

double first_of(const std::vector<SharedQuantity>& quantities) {
  double first = INFINITY;
  for (const SharedQuantity& quantity : quantities)
    if (!quantity.robot.empty()) first = std::min(first, quantity.robot.front().at);
  return first;
}

double last_of(const std::vector<SharedQuantity>& quantities) {
  double last = -INFINITY;
  for (const SharedQuantity& quantity : quantities)
    if (!quantity.robot.empty()) last = std::max(last, quantity.robot.back().at);
  return last;
}

/// Returns the quantities with the robot's values from `from` to `to` [s].
std::vector<SharedQuantity> part_of(const std::vector<SharedQuantity>& quantities, double from, double to) {
  std::vector<SharedQuantity> part;
  for (const SharedQuantity& whole : quantities) {
    const auto begin = std::ranges::lower_bound(whole.robot, from, {}, &Sample::at);
    const auto end = std::ranges::lower_bound(whole.robot, to, {}, &Sample::at);
    part.push_back(whole);
    part.back().robot.assign(begin, end);
  }
  return part;
}

std::vector<PartOffset> parts_of(const std::vector<SharedQuantity>& quantities, double coarse) {
  std::vector<PartOffset> parts;
  const double first = first_of(quantities), last = last_of(quantities);
  const double count = std::floor((last - first) / kPart), length = (last - first) / count;
  for (double i = 0; i < count; ++i) {
    const auto part = part_of(quantities, first + i * length, first + (i + 1) * length);
    // a drift of 100 ppm moves the offset by 0.36 s in an hour
    const auto near = find_coarse_lag(part, {.middle = coarse, .reach = 1});
    if (!near) continue;
    if (const auto lag = refined_lag(part, near->seconds, kPartDeviation))
      parts.push_back({.middle = first + (i + 0.5) * length, .lag = *lag});
  }
  return parts;
}

}  // namespace

DataOffset line_through(const std::vector<PartOffset>& parts) {
  const auto weight_of = [](const PartOffset& part) { return 1 / (part.lag.deviation * part.lag.deviation); };
  // about the weighted middle, so that offset and drift are independent
  double weights = 0, times = 0, lags = 0;
  for (const PartOffset& part : parts)
    weights += weight_of(part), times += weight_of(part) * part.middle, lags += weight_of(part) * part.lag.seconds;
  DataOffset line{.offset = lags / weights, .middle = times / weights};
  double spread = 0, slope = 0, scatter = 0;
  for (const PartOffset& part : parts) {
    const double far = part.middle - line.middle;
    spread += weight_of(part) * far * far;
    slope += weight_of(part) * far * part.lag.seconds;
  }
  line.drift = slope / spread;
  for (const PartOffset& part : parts) {
    const double residual = part.lag.seconds - line.offset - line.drift * (part.middle - line.middle);
    scatter += weight_of(part) * residual * residual;
  }
  const double increase = std::sqrt(std::max(1.0, scatter / static_cast<double>(parts.size() - 2)));
  line.deviation = increase / std::sqrt(weights);
  line.drift_deviation = increase / std::sqrt(spread);
  return line;
}

Result<DataOffset> find_offset(const std::vector<SharedQuantity>& quantities, const LagRange& range) {
  const auto coarse = find_coarse_lag(quantities, range);
  if (!coarse) return coarse.failure();
  const double first = first_of(quantities), last = last_of(quantities);
  if (last - first >= static_cast<double>(kLeastParts) * kPart) {
    const auto parts = parts_of(quantities, coarse->seconds);
    if (parts.size() >= kLeastParts) return line_through(parts);
  }
  const auto lag = refined_lag(quantities, coarse->seconds);
  if (!lag) return lag.failure();
  return DataOffset{.offset = lag->seconds, .deviation = lag->deviation, .middle = (first + last) / 2};
}

}  // namespace robot::lab
