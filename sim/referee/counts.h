// Who touched the ball, and the statistics of a game.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee {

/// While in play: notes touches, counts kicks, whiffs, shots, possession.
void keep_counts(Court& court);

/// The ball, if nobody touches it any more, rolls wholly over the goal line that `side` attacks, between the posts.
bool rolls_into_goal(const Court& court, Side side);

}  // namespace sim::referee
