// One tick of many games. The only place of the environment that steps a game.
#pragma once

#include "sim/match/params.h"
#include "sim/match/state.h"
#include "sim/referee/event.h"

namespace sim::environment {

/// Plays one tick of each game; events[i] are those of games[i].
void advance(const Params& params, State* const* games, referee::Events* events, int count);

}  // namespace sim::environment
