// A game as one line of JSON, for the evaluation of thousands.
#pragma once

#include <cstdint>
#include <string>

#include "sim/match/params.h"

namespace sim::report {

/// Plays a game and returns its figures, with a newline at the end. They are those of its report, the time of the first goal,
/// the number of balls out, how often each robot saw the ball, and those of a Census.
std::string game_line(const Params& params, std::uint64_t seed);

}  // namespace sim::report
