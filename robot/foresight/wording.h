// What the captain does with an answer, in words.
#pragma once

#include <string>

#include "proto/foresight/forecast.pb.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// Why the captain, which played `before`, plays `chosen` from now on: one sentence with the numbers behind it, true of
/// these two, whatever else was asked about. "back to baseline: kick_now would gain 0.04 ± 0.09 goals, which may be
/// chance (212 futures)". The forecast has advice.
std::string reason_of(const pb::Forecast& forecast, const std::string& before, const std::string& chosen);

}  // namespace robot::foreseeing
