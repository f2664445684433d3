// Touches of the ball and the statistics of a game.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee {

/// Notes touches and counts kicks, whiffs, shots and possession. Call it once a tick in play.
void keep_counts(Court& court);

/// Reports whether the ball would roll into the goal that `side` attacks if nobody touched it any more.
bool rolls_into_goal(const Court& court, Side side);

}  // namespace sim::referee
