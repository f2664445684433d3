#include "robot/truth/sensor/device_clock.h"

#include <algorithm>
#include <cmath>

#include "robot/core/clock.h"

namespace robot::truth {
namespace {

constexpr double kWindow = 5;        // [s]
constexpr double kDisagreement = 1;  // [s]

}  // namespace

std::uint64_t DeviceClock::capture_ns(std::uint64_t ticks, std::uint64_t arrival_ns) {
  const bool first = !last_ticks_;
  const std::uint64_t mask = bits_ < 64 ? (std::uint64_t{1} << bits_) - 1 : ~std::uint64_t{0};
  if (!first) device_s_ += static_cast<double>((ticks - *last_ticks_) & mask) / ticks_per_second_;
  last_ticks_ = ticks;

  const auto since_first_ns = static_cast<double>(static_cast<std::int64_t>(arrival_ns - first_ns_));
  const double offset = since_first_ns / static_cast<double>(kSecond) - device_s_;
  if (first || std::abs(offset - std::min(least_, least_before_)) > kDisagreement) {
    restart(arrival_ns);
    return arrival_ns;
  }
  // the older window ends, the present one becomes the older one
  if (device_s_ - window_start_s_ > kWindow) {
    least_before_ = least_;
    least_ = offset;
    window_start_s_ = device_s_;
  }
  least_ = std::min(least_, offset);
  const double late = offset - std::min(least_, least_before_);
  return arrival_ns - static_cast<std::uint64_t>(std::llround(late * static_cast<double>(kSecond)));
}

/// Learns again, from an image that arrives now.
void DeviceClock::restart(std::uint64_t arrival_ns) {
  first_ns_ = arrival_ns;
  device_s_ = window_start_s_ = 0;
  least_ = least_before_ = 0;
}

}  // namespace robot::truth
