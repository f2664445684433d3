// Watches this machine's system clock: recorded steps are what lets recordings of several machines be put side by side.
#pragma once

#include <cstdint>
#include <optional>

#include "proto/foresight/runtime.pb.h"

namespace robot::app {

/// Makes a ClockSample of each look at the two clocks. Used by one thread.
class ClockService {
 public:
  /// `epoch_offset_ns`: what the session's clock adds to the monotonic one.
  explicit ClockService(std::uint64_t epoch_offset_ns) : epoch_offset_ns_(epoch_offset_ns) {}

  /// The sample of a moment at which the clocks show `monotonic_ns` and `system_ns`. A change of their difference since
  /// the last sample beyond what slewing does in that time (500 ppm, the kernel's limit) counts as a step.
  foresight::ClockSample sample(std::uint64_t monotonic_ns, std::uint64_t system_ns);

 private:
  const std::uint64_t epoch_offset_ns_;
  std::optional<std::int64_t> last_difference_ns_;
  std::uint64_t last_monotonic_ns_ = 0;
};

}  // namespace robot::app
