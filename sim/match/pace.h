// How often a robot has to perceive, decide and be moved.
//
// With Pace::thinned a robot that cannot matter now does all three once for several ticks: one perception of that many
// ticks, one decision, one longer move. It cannot matter while
//   - it is far from the ball and from where the ball rolls to in the next second: a walking robot covers 0.3 m in it;
//   - it neither kicks nor is the one who goes for the ball;
//   - nobody is so near that they could touch before its turn comes again.
// While the ball is not in play everybody only walks to a place or stands, so the pace is lower still.
//
// Turns are by player number: the same number of both sides has its turn in the same tick, so neither side nor a
// mirrored game is ahead. Contacts, the ball and the referee are judged in every tick for everybody.
#pragma once

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim {

/// [ticks] until the robot's next turn, at least 1; asked after its decision, before anybody moves. A function of the
/// world and the robot alone: not of who is asked first.
Tick ticks_to_next_turn(const Params& params, const State& state, int robot);

}  // namespace sim
