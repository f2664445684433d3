// The conversion of one clock's times to those of another clock.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "robot/core/clock.h"

namespace robot {

/// A shift of times from a clock of another machine to ours. It changes in time if the clocks drift.
class ClockShift {
 public:
  /// Adds `by_ns` to every time.
  ClockShift(std::int64_t by_ns = 0) : by_ns_(by_ns) {}

  /// Adds `by_ns` to the time `around_ns` of the other clock, and `growth` [ns/ns] more to later ones. The drift of a day is
  /// the most that is added.
  ClockShift(std::int64_t by_ns, double growth, std::uint64_t around_ns)
      : by_ns_(by_ns), growth_(growth), around_ns_(around_ns) {}

  /// Reports whether all times stay as they are.
  bool is_none() const { return by_ns_ == 0 && growth_ == 0; }

  /// Returns our time for a time of the other clock.
  std::uint64_t operator()(std::uint64_t time_ns) const {
    return time_ns + static_cast<std::uint64_t>(by_ns_ + grown(time_ns, growth_));
  }

  /// Returns the time of the other clock for our time. A time before its 0 is 0.
  std::uint64_t back(std::uint64_t time_ns) const {
    const std::uint64_t about_ns = time_ns - static_cast<std::uint64_t>(by_ns_);
    const std::int64_t shift_ns = by_ns_ + grown(about_ns, growth_ / (1 + growth_));
    const auto magnitude_ns = static_cast<std::uint64_t>(shift_ns);
    return shift_ns > 0 && time_ns < magnitude_ns ? 0 : time_ns - magnitude_ns;
  }

 private:
  std::int64_t grown(std::uint64_t time_ns, double growth) const {
    constexpr double kDayNs = 24.0 * 3600 * static_cast<double>(kSecond);
    const auto since_ns = static_cast<double>(static_cast<std::int64_t>(time_ns - around_ns_));
    return growth == 0 ? 0 : std::llround(growth * std::clamp(since_ns, -kDayNs, kDayNs));
  }

  std::int64_t by_ns_;
  double growth_ = 0;
  std::uint64_t around_ns_ = 0;
};

}  // namespace robot
