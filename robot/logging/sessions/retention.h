// The choice of sessions that are deleted to make room. It does not depend on a clock alone, because a robot's clock may
// say 1970.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/logging/sessions/session.h"

namespace robot::logging {

/// A session younger than this by any clock is never deleted to make room [ns].
inline constexpr std::uint64_t kSafeAgeNs = 24ull * 3600 * 1'000'000'000;

/// The clocks at hand.
struct Now {
  std::vector<std::uint64_t> times_ns;  // [ns since the epoch] of each clock; one of them may be wrong by decades
  std::string boot;                     // boot_id(); empty: unknown
};

/// Returns whether `session` may be deleted to make room. False for one that is kept, being recorded, of this boot, or
/// less than kSafeAgeNs from a clock in `now`, by its messages or by the time of its files.
bool is_deletable(const Session& session, const Now& now);

/// Returns whether `left` was recorded before `right`: by number, then by time. Sessions without a number are older than
/// all others.
bool is_older(const Session& left, const Session& right);

}  // namespace robot::logging
