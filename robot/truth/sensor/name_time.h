// Capture times in the names of image files.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace robot::truth {

/// Returns the time [ns since the epoch] that a file's name contains, or nothing if it contains none after 1989:
///   1305031102.160407      seconds with a fraction, as in TUM recordings and those of fakenect-record
///   1305031102160          milliseconds (13 digits), microseconds (16) or nanoseconds (19)
///   20121214T142255.814212 a date, as in PCL's recordings; their local time is taken for UTC, as they name no zone
std::optional<std::uint64_t> time_in_name(std::string_view name);

}  // namespace robot::truth
