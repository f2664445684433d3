// How often a robot has to perceive, decide and be moved.
//
// With Pace::thinned a robot that cannot matter now does all three once for several ticks: one perception of all their
// images, one decision, one longer move. How much it matters is how soon it could have to do with the ball or touch
// another robot: a Nao covers 0.3 m in a second, so from a metre beside the ball's path it takes seconds, and whether
// it decides about them thirty times a second or three times leads to the same place. Next to the ball and to where it
// rolls in the next second it decides in every other tick. A kick that has begun is waited for; in the phase set
// everybody stands.
//
// Turns lie on multiples of their period, for both sides alike: neither side nor a mirrored game is ahead, and many
// ticks are nobody's. Contacts, the ball and the referee are judged in every tick for everybody.
// scripts/bench equivalence shows how near games come to those of the plain run: with models `match` within all margins;
// with perfect models they have 8 % fewer shots.
#pragma once

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim {

/// [ticks] How long a robot waits, at least 1.
struct Wait {
  Tick turn;  // for its next turn
  Tick move;  // until its body moves on, at most until then
};

/// Asked after the robot's decision, before anybody moves. A function of the world and the robot alone: not of who is
/// asked first.
Wait wait_of(const Params& params, const State& state, int robot);

/// The world to look at: in a state, a robot that rests is where its next turn begins; here it is on the way there, as
/// far as it has rested. [field]
World between_turns(const State& state);

}  // namespace sim
