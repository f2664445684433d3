// The rate of a sensor's images and the time that each of them costs.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "robot/core/clock.h"

namespace robot::app {

/// The last images of a sensor. Used by one thread.
class Pulse {
 public:
  /// Counts an image that was ready at `now_ns` [ns, monotonic] and cost `cpu_ns` of processor time.
  void add(std::uint64_t now_ns, std::uint64_t cpu_ns) {
    beats_[count_ % beats_.size()] = {now_ns, cpu_ns};
    ++count_;
  }

  /// Returns the images a second over the last 30, or 0 before the second one and 2 s after the last one.
  double rate_hz(std::uint64_t now_ns) const {
    const std::size_t kept = std::min(count_, beats_.size());
    if (kept < 2) return 0;
    const std::uint64_t newest_ns = beats_[(count_ - 1) % beats_.size()].now_ns;
    const std::uint64_t oldest_ns = beats_[(count_ - kept) % beats_.size()].now_ns;
    if (now_ns > newest_ns + 2 * kSecond || newest_ns <= oldest_ns) return 0;
    return static_cast<double>(kept - 1) * 1e9 / static_cast<double>(newest_ns - oldest_ns);
  }

  /// Returns the median cost of the last 30 images [ms], or 0 without one.
  double milliseconds() const {
    const std::size_t kept = std::min(count_, beats_.size());
    if (kept == 0) return 0;
    std::array<std::uint64_t, 30> costs{};
    for (std::size_t i = 0; i < kept; ++i) costs[i] = beats_[i].cpu_ns;
    const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(kept / 2);
    std::nth_element(costs.begin(), middle, costs.begin() + static_cast<std::ptrdiff_t>(kept));
    return static_cast<double>(*middle) / 1e6;
  }

 private:
  struct Beat {
    std::uint64_t now_ns = 0, cpu_ns = 0;
  };
  std::array<Beat, 30> beats_{};
  std::size_t count_ = 0;
};

}  // namespace robot::app
