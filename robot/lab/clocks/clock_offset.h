// How far another machine's clock is ahead, and whether two machines can be looked at together.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"

namespace robot::lab {

/// What is to be added to one clock's time to get another's, and how wrong that may be at most.
struct ClockOffset {
  std::int64_t offset_ns = 0;  // [ns] > 0: the other clock is ahead
  std::uint64_t error_ns = 0;  // [ns] half a round trip
};

/// What one NTP-like exchange tells of the other's clock: it was asked at `sent_ns`, answered that it was `theirs_ns`
/// there, and that came at `returned_ns`, both our time.
ClockOffset offset_by(std::uint64_t sent_ns, std::uint64_t theirs_ns, std::uint64_t returned_ns);

/// The better one of two: that of the shorter round trip.
ClockOffset better(const std::optional<ClockOffset>& known, const ClockOffset& other);

/// Clocks that agree so well need no setting right: a third of a camera's period, so that frames stay beside each other.
inline constexpr std::uint64_t kAgreeNs = 10 * kMillisecond;

/// "0.350 s ahead (± 0.4 ms)".
std::string to_text(const ClockOffset& offset);

/// What is to be added to the other clock's times to get ours: nothing where both agree within what can be measured.
/// An Error that tells the offset where it is beyond `most_ns`; `who` is whose clock it is, in the genitive: "14/3's".
Result<std::int64_t> correction(const ClockOffset& offset, std::uint64_t most_ns, const std::string& who);

}  // namespace robot::lab
