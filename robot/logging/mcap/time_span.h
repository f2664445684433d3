// The span of time that a recording covers, without stray messages.
#pragma once

#include <cstdint>
#include <string>

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

/// Returns the span of the file's largest group of messages. A clock that was not set gives messages at time 0 or in
/// 1970, which would stretch the time line to decades. Unpacks only chunks that reach over such a gap.
TimeSpan time_span(const ByteSource& source, const McapIndex& index);

}  // namespace robot::logging
