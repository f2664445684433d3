#include "robot/lab/clocks/data_offset.h"

#include <algorithm>

namespace robot::lab {
namespace {

constexpr double kPart = 120;            // [s]
constexpr double kPartDeviation = 0.06;  // [s] parts with a larger one do not count
constexpr std::size_t kLeastParts = 3;

/// Returns the offsets of the parts that tell one.
std::vector<PartOffset> parts_of(const SharedDistance& distance, double coarse) {
  std::vector<PartOffset> parts;
  SharedDistance part = distance;
  for (auto begin = distance.seen.begin(); begin != distance.seen.end();) {
    const auto end = std::ranges::lower_bound(begin, distance.seen.end(), begin->at + kPart, {}, &Sample::at);
    part.seen.assign(begin, end);
    begin = end;
    // a drift of 100 ppm moves the offset by 0.36 s in an hour
    const auto near = find_coarse_lag(part, {.middle = coarse, .reach = 1});
    if (!near) continue;
    if (const auto lag = refined_lag(part, near->seconds, kPartDeviation))
      parts.push_back({.middle = (part.seen.front().at + part.seen.back().at) / 2, .lag = *lag});
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

Result<DataOffset> find_offset(const SharedDistance& distance, const LagRange& range) {
  const auto coarse = find_coarse_lag(distance, range);
  if (!coarse) return coarse.failure();
  const double first = distance.seen.front().at, last = distance.seen.back().at;
  if (last - first >= static_cast<double>(kLeastParts) * kPart) {
    const auto parts = parts_of(distance, coarse->seconds);
    if (parts.size() >= kLeastParts) return line_through(parts);
  }
  const auto lag = refined_lag(distance, coarse->seconds);
  if (!lag) return lag.failure();
  return DataOffset{.offset = lag->seconds, .deviation = lag->deviation, .middle = (first + last) / 2};
}

}  // namespace robot::lab
