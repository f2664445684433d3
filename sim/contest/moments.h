// Moments in the midst of games, at which somebody might ask what becomes of them.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::contest {

/// Plays a game and shows it at most `count` times, evenly spaced, in play. Each time `robot` (its index) has just had its
/// turn, as a captain who asks: between two of its turns its beliefs would be as old as half a second.
void for_each_moment(const Params& params, std::uint64_t seed, int count, int robot,
                     const std::function<void(const State&)>& see);

}  // namespace sim::contest
