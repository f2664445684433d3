// How often a robot has to perceive, decide and be moved.
//
// With Pace::thinned a robot that cannot matter now does all three once for several ticks: one perception of that many
// ticks, one decision, one longer move. How much it matters is how soon it could have to do with the ball: a Nao covers
// 0.3 m in a second, so from a metre beside the ball's path it takes seconds, and whether it decides about them thirty
// times a second or five times leads to the same place. Where a decision tells, it is taken in every tick: next to the
// ball and to where it rolls in the next second, until a kick has been done, and among robots that may touch.
// Before the ball is in play everybody walks to a place or stands; in the phase set nobody may move at all.
//
// Turns are by player number: the same number of both sides has its turn in the same tick, so neither side nor a
// mirrored game is ahead. Contacts, the ball and the referee are judged in every tick for everybody.
// scripts/bench equivalence shows that games come out as those of the plain run.
#pragma once

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim {

/// [ticks] until the robot's next turn, at least 1; asked after its decision, before anybody moves. A function of the
/// world and the robot alone: not of who is asked first.
Tick ticks_to_next_turn(const Params& params, const State& state, int robot);

}  // namespace sim
