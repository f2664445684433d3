// The comparison of clocks of several recordings, by their recorded clock samples.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/clock_shift.h"
#include "robot/core/result.h"
#include "robot/lab/clocks/clock_offset.h"
#include "robot/logging/sessions/session.h"

namespace robot::lab {

/// The clock of a recorded session.
struct RecordedClock {
  std::string who;                           // "14/2", or "lab/1" if a machine of the lab relayed robots
  std::map<std::string, ClockOffset> peers;  // compared machines: "10.0.14.7", "14/2"
};

/// Reads the clock samples of a session. For each peer the sample of the shortest round trip counts. Other samples may
/// contradict it by more than their own error, because clocks drift or were stepped; the contradiction adds to its
/// error. Peers at a loopback address are left out, because that is another machine for each robot. A session without
/// samples has no peers.
RecordedClock read_clock(const logging::Session& session);

/// The offset of a clock to another one, and its source.
struct ClockComparison {
  ClockOffset offset;
  std::string by;  // the peer that measured both, "10.0.14.7"; empty: one of the two measured the other
};

/// Returns the offset by which `other` is ahead of `reference`, with the smallest error of all peers. Returns nothing
/// if the two have no peer in common.
std::optional<ClockComparison> compare(const RecordedClock& reference, const RecordedClock& other);

/// The growth of the offset of two clocks.
struct ClockDrift {
  double growth = 0;            // [ns/ns] 0: not significant, and not applied
  std::uint64_t around_ns = 0;  // [ns since the epoch, other clock] the time at which the offset was measured
};

/// The result of the comparison for one session.
struct Agreement {
  std::int64_t shift_ns = 0;  // to add to the session's times
  ClockDrift drift = {};      // by which this shift shrinks
  std::string sentence;       // for people; empty for the first session
  bool known = true;          // false: the clocks could not be compared

  /// Returns the shift of the session's times.
  ClockShift shift() const { return {shift_ns, -drift.growth, drift.around_ns}; }
};

/// The owners of two clocks.
struct ClockOwners {
  std::string reference, other;
};

/// Returns the shift for the `other` clock, which is ahead of `reference` by a known offset. `by` is the source of that
/// offset; empty: one of the two measured the other. A clock that drifts is shifted also if its offset is small. Returns an
/// Error if the offset exceeds `most_ns`.
Result<Agreement> agreement_by(const ClockOwners& owners, const ClockOffset& offset, const std::string& by,
                               std::uint64_t most_ns, const ClockDrift& drift = {});

/// Returns the agreement of two clocks whose times stay unchanged, and the reason.
Agreement no_agreement(const ClockOwners& owners, const std::string& reason);

/// Greatest useful error [ns] of an offset. A ball rolls half a metre in that time.
inline constexpr std::uint64_t kUselessNs = 250 * kMillisecond;

/// Compares all clocks with the first. Returns an Error with the offset if one differs by more than `most_ns`.
Result<std::vector<Agreement>> agree(const std::vector<RecordedClock>& clocks, std::uint64_t most_ns);

}  // namespace robot::lab
