// A game in one line of JSON, for whoever evaluates thousands.
#pragma once

#include <cstdint>
#include <string>

#include "sim/match/params.h"

namespace sim::report {

/// Plays a game and tells what it was like: the figures of its report, when the first goal fell, how often the ball
/// went out, which robot saw it how often, and what a Census finds. Ends with a newline.
std::string game_line(const Params& params, std::uint64_t seed);

}  // namespace sim::report
