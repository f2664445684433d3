// Names of the files that fakenect-record writes.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::truth {

struct FakenectName {
  char kind = 'd';               // d: depth, r: colour, a: acceleration
  std::uint64_t capture_ns = 0;  // [ns since the epoch] the recording computer's clock when the image had arrived
};

/// Reads a name such as "d-1294851097.453589-2279103905.pgm": kind, seconds, ticks of the sensor.
Result<FakenectName> parse_fakenect_name(std::string_view name);

/// Returns the file names of an INDEX.txt, one per line.
std::vector<std::string_view> parse_fakenect_index(std::string_view text);

}  // namespace robot::truth
