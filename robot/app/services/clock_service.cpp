#include "robot/app/services/clock_service.h"

#include <cstdlib>

namespace robot::app {
namespace {

/// Tolerance [ns] for the time between the two readings, in addition to 500 ppm of slewing (adjtimex(2)).
constexpr std::int64_t kReadingNs = 1'000'000;

std::int64_t slew_limit_ns(std::uint64_t elapsed_ns) {
  return static_cast<std::int64_t>(elapsed_ns / 2000) + kReadingNs;
}

}  // namespace

foresight::ClockSample ClockService::sample(std::uint64_t monotonic_ns, std::uint64_t system_ns) {
  const auto difference_ns = static_cast<std::int64_t>(system_ns - monotonic_ns);
  foresight::ClockSample sample;
  sample.set_source(foresight::ClockSample::SOURCE_SYSTEM);
  sample.set_monotonic_ns(monotonic_ns);
  sample.set_system_ns(system_ns);
  sample.set_offset_ns(difference_ns - static_cast<std::int64_t>(epoch_offset_ns_));
  if (last_difference_ns_) {
    const std::int64_t change_ns = difference_ns - *last_difference_ns_;
    if (std::abs(change_ns) > slew_limit_ns(monotonic_ns - last_monotonic_ns_)) sample.set_step_ns(change_ns);
  }
  last_difference_ns_ = difference_ns;
  last_monotonic_ns_ = monotonic_ns;
  return sample;
}

}  // namespace robot::app
