// Differences of times.
#pragma once

#include <cstdint>

namespace robot::truth {

/// Returns the time [s] from the one to the other [ns], also backwards.
inline double seconds_between(std::uint64_t from_ns, std::uint64_t to_ns) {
  return to_ns >= from_ns ? 1e-9 * static_cast<double>(to_ns - from_ns) : -1e-9 * static_cast<double>(from_ns - to_ns);
}

}  // namespace robot::truth
