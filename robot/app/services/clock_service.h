// Samples of this machine's system clock. The recorded offsets and steps allow recordings of several machines to share
// a time base.
#pragma once

#include <cstdint>
#include <optional>

#include "proto/foresight/runtime.pb.h"

namespace robot::app {

/// The sampler of the system clock against the monotonic clock. Used by one thread.
class ClockService {
 public:
  /// `epoch_offset_ns`: offset of the session's clock to the monotonic one.
  explicit ClockService(std::uint64_t epoch_offset_ns) : epoch_offset_ns_(epoch_offset_ns) {}

  /// Returns the sample of a moment at which the clocks show `monotonic_ns` and `system_ns`. Their difference may
  /// change by 500 ppm since the last sample, the kernel's limit of slewing. A larger change counts as a step.
  foresight::ClockSample sample(std::uint64_t monotonic_ns, std::uint64_t system_ns);

 private:
  const std::uint64_t epoch_offset_ns_;
  std::optional<std::int64_t> last_difference_ns_;
  std::uint64_t last_monotonic_ns_ = 0;
};

}  // namespace robot::app
