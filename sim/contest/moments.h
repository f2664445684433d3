// Moments in the middle of games, for questions about their continuation.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::contest {

/// Plays a game and calls `see` at most `count` times, evenly spaced, while the ball is in play. Each time `robot` (its
/// index) has just had its turn, like a captain that asks. Between two turns its beliefs would be up to half a second old.
void for_each_moment(const Params& params, std::uint64_t seed, int count, int robot,
                     const std::function<void(const State&)>& see);

}  // namespace sim::contest
