// How old the newest packet of a mate is.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/fit/radio/packets.h"

namespace robot::fit {

/// The share of time in which the newest packet of a mate is older than an age.
struct AgeCurve {
  std::vector<double> ages;    // [s] ascending
  std::vector<double> shares;  // of equal length
};

/// Returns the curve as the robots had it. The age counts from sending, or from the arrival if the time of sending is not
/// known. Silences of more than ten seconds do not count.
AgeCurve observed_ages(const std::vector<TeamRecord>& records);

/// Returns the curve for a radio with the given mean delay [s] and loss, at the times at which the robots sent. The same for
/// the same packets. Without recorded senders it is empty.
AgeCurve expected_ages(const std::vector<TeamRecord>& records, double delay, double loss);

}  // namespace robot::fit
