// The span of time that a recording covers, without stray messages.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/byte_source.h"
#include "robot/logging/mcap/index.h"

namespace robot::logging {

/// The time line of a file. Both ends are 0 without messages.
struct TimeSpan {
  std::uint64_t start_ns = 0, end_ns = 0;  // [ns since the epoch]
  std::uint64_t before = 0, after = 0;     // stray messages outside

  /// Returns a sentence about the stray messages, or an empty string if there are none.
  std::string note() const;
};

/// Messages farther apart than this belong to different groups: 30 days [ns]. No recording pauses for so long.
inline constexpr std::uint64_t kStrayGapNs = 30ULL * 24 * 3600 * 1'000'000'000;

/// Messages whose neighbours are near in time.
struct TimeGroup {
  std::uint64_t start_ns = 0, end_ns = 0;  // [ns since the epoch]
  std::uint64_t messages = 0;
};

/// Returns the groups of a file's messages. Unpacks only chunks that reach over a gap.
std::vector<TimeGroup> time_groups(const ByteSource& source, const McapIndex& index);

/// Returns the span of the largest of the groups, which may come from several files. A clock that was not set gives messages
/// at time 0 or in 1970, which would stretch the time line to decades.
TimeSpan time_span(std::vector<TimeGroup> groups);

/// As before, for one file.
inline TimeSpan time_span(const ByteSource& source, const McapIndex& index) {
  return time_span(time_groups(source, index));
}

}  // namespace robot::logging
