// Measures the clock rate of this processor without a system call for it.
#pragma once

#include <cstdint>

namespace sim::app {

/// Returns the computing time of the calling thread [ns]. Other threads and processes do not count.
std::uint64_t computed_ns();

/// Measures the cycles per nanosecond with a loop of dependent additions: one per cycle on every supported processor.
/// Takes about a millisecond. Uses the fastest of 5 tries, because other load can only slow a try down.
double cycles_per_ns();

}  // namespace sim::app
