// The captain's decision in words.
#pragma once

#include <string>

#include "proto/foresight/forecast.pb.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// Returns the reason for the change from `before` to `chosen`, one sentence with the numbers of these two strategies.
/// Example: "back to baseline: kick_now would gain 0.04 ± 0.09 goals, which may be chance (212
/// futures)". The forecast has advice.
std::string reason_of(const pb::Forecast& forecast, const std::string& before, const std::string& chosen);

}  // namespace robot::foreseeing
