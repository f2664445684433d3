// The time of a sensor's own clock on the computer's clock.
#pragma once

#include <cstdint>
#include <optional>

namespace robot::truth {

/// A conversion of a sensor's counter to the epoch, learned from the arrival of images.
///
/// An image arrives late by a varying time, never early. So the least difference between arrival and counter in the last 5
/// to 10 seconds is the best estimate of their offset; the window follows a crystal that drifts. The least delay, between
/// the exposure and its earliest possible arrival, remains: no clock of the computer shows it.
class DeviceClock {
 public:
  /// `ticks_per_second` of the counter, which starts again from 0 after `bits` bits.
  DeviceClock(double ticks_per_second, int bits) : ticks_per_second_(ticks_per_second), bits_(bits) {}

  /// Returns the capture time [ns since the epoch] of an image with this counter that arrived at `arrival_ns` [ns since the
  /// epoch]. It is never after the arrival. Call it once for each image, in their order. A counter that disagrees with the
  /// arrivals by more than a second started anew: the offset is learned again.
  std::uint64_t capture_ns(std::uint64_t ticks, std::uint64_t arrival_ns);

 private:
  void restart(std::uint64_t arrival_ns);

  double ticks_per_second_;
  int bits_;
  std::optional<std::uint64_t> last_ticks_;
  double device_s_ = 0;                  // since the first image
  std::uint64_t first_ns_ = 0;           // arrival of the first image
  double window_start_s_ = 0;            // on the counter
  double least_ = 0, least_before_ = 0;  // [s] arrival minus counter, of this and of the previous window
};

}  // namespace robot::truth
