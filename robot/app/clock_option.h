// The option --max-clock-offset of the lab's commands.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <string>

#include "robot/core/result.h"

namespace robot::app {

/// Declares the option --max-clock-offset [s], which sets `seconds`.
inline void add_clock_option(CLI::App& command, double& seconds) {
  command
      .add_option("--max-clock-offset", seconds,
                  "[s] refuse a machine with a larger clock offset; correct the times of others")
      ->capture_default_str();
}

/// Converts the value of --max-clock-offset [s] to nanoseconds. Returns an Error outside 0 .. 1e9 s.
inline Result<std::uint64_t> clock_offset_ns(double seconds) {
  if (seconds >= 0 && seconds <= 1e9) return static_cast<std::uint64_t>(std::llround(seconds * 1e9));
  return Error{"--max-clock-offset: expected 0 .. 1e9 [s], got " + std::to_string(seconds)};
}

}  // namespace robot::app
