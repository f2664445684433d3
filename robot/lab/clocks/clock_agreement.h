// Whether recordings of several machines can be put side by side: what their clock samples tell of their clocks.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/lab/clocks/clock_offset.h"
#include "robot/logging/sessions/session.h"

namespace robot::lab {

/// The clock that a session was recorded by.
struct RecordedClock {
  std::string who;                           // "14/2", or "lab/1" where a machine of the lab relayed robots
  std::map<std::string, ClockOffset> peers;  // machines it was compared with: "10.0.14.7", "14/2"
};

/// Reads the clock samples of a session. Of each peer the shortest round trip counts; what other samples say against
/// it beyond their own error, because clocks drift or were stepped, adds to its error. Peers at a loopback address are
/// left out: that is another machine for each robot. A session without samples has no peers.
RecordedClock read_clock(const logging::Session& session);

/// How far a clock is ahead of another one, and how that is known.
struct ClockComparison {
  ClockOffset offset;
  std::string by;  // "10.0.14.7"; empty: one asked the other
};

/// How far `other` is ahead of `reference`, by the peer that tells it best; nothing where no peer is of both.
std::optional<ClockComparison> compare(const RecordedClock& reference, const RecordedClock& other);

/// What follows for a session that is played with others.
struct Agreement {
  std::int64_t shift_ns = 0;  // to add to its times
  std::string sentence;       // for people; empty for the first
};

/// Compares all clocks with the first. An Error that names the offset where one is further off than `most_ns`.
Result<std::vector<Agreement>> agree(const std::vector<RecordedClock>& clocks, std::uint64_t most_ns);

}  // namespace robot::lab
