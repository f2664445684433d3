// Moments in the middle of games, as starting points of forecasts.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::contest {

/// Plays a game and calls `see` at most `count` times, at equal intervals, while the ball is in play. At each call
/// `robot` (an index) has just had its turn, as a captain that asks for a forecast has. Between two turns its beliefs
/// can be half a second old.
void for_each_moment(const Params& params, std::uint64_t seed, int count, int robot,
                     const std::function<void(const State&)>& see);

}  // namespace sim::contest
