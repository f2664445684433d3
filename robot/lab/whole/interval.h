// The summary of the values of one interval of time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace robot::lab {

/// Number, minimum, maximum and mean of finite values. least <= mean() <= most if there is any value.
struct Interval {
  std::uint64_t count = 0;
  double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
  double sum = 0;

  /// Leaves out values that are not finite.
  void add(double value) {
    if (std::isfinite(value)) merge({.count = 1, .least = value, .most = value, .sum = value});
  }

  /// Adds the values of `other`. To merge intervals equals computing at once.
  void merge(const Interval& other) {
    count += other.count;
    least = std::min(least, other.least);
    most = std::max(most, other.most);
    sum += other.sum;
  }

  /// Returns the mean. Sums that overflow, of values near the greatest double, give another value of the interval.
  double mean() const {
    const double mean = sum / static_cast<double>(count);
    return std::isnan(mean) ? least : std::clamp(mean, least, most);
  }
};

}  // namespace robot::lab
