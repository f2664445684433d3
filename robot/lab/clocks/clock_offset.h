// The offset between the clocks of two machines, and its correction.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"

namespace robot::lab {

/// The offset to add to one clock's time to get another clock's time, with its greatest error.
struct ClockOffset {
  std::int64_t offset_ns = 0;  // [ns] > 0: the other clock is ahead
  std::uint64_t error_ns = 0;  // [ns] half a round trip
};

/// Returns the offset from one NTP-like exchange: the request left at `sent_ns` and the answer arrived at
/// `returned_ns`, both by our clock; `theirs_ns` is the peer's time in the answer.
ClockOffset offset_by(std::uint64_t sent_ns, std::uint64_t theirs_ns, std::uint64_t returned_ns);

/// Returns the one with the shorter round trip.
ClockOffset better(const std::optional<ClockOffset>& known, const ClockOffset& other);

/// Offset that needs no correction: a third of a camera's period, so that images of the same moment stay together.
inline constexpr std::uint64_t kAgreeNs = 10 * kMillisecond;

/// Formats an offset: "0.350 s ahead (± 0.4 ms)".
std::string to_text(const ClockOffset& offset);

/// Returns the shift to add to the other clock's times to get ours: 0 if both agree within kAgreeNs and the error of
/// measurement. Returns an Error with the offset if it exceeds `most_ns`. `who` is the clock's owner in the genitive:
/// "14/3's".
Result<std::int64_t> correction(const ClockOffset& offset, std::uint64_t most_ns, const std::string& who);

}  // namespace robot::lab
