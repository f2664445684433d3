// The option of the lab's commands that says how far a clock may be off.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "robot/core/result.h"

namespace robot::app {

/// [ns] of what a person gave in seconds; an Error if that cannot be.
inline Result<std::uint64_t> clock_offset_ns(double seconds) {
  if (seconds >= 0 && seconds <= 1e9) return static_cast<std::uint64_t>(std::llround(seconds * 1e9));
  return Error{"--max-clock-offset: expected 0 .. 1e9 [s], got " + std::to_string(seconds)};
}

}  // namespace robot::app
