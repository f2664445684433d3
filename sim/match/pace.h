// How often a robot has to perceive, decide and be moved.
//
// With Pace::thinned a robot does all three once for several ticks: one perception of all their images, one decision, one
// longer move. How many is how soon it could matter:
//   - whoever walks finishes its step before its legs heed anything new (sim/motion/rhythm.h), so it decides when a step
//     begins: with each near the ball and where that rolls in the next second, else with every second. Within 0.8 m of
//     the ball it looks once more in between; without that games have 4 % more shots than the plain run. Next to the
//     ball or to another robot its body goes through the step in pieces, because contacts are judged in every tick;
//   - whoever stands decides in every other tick where the ball is near or comes near; with longer waits robots block
//     too late, and without noise games have 10 % more goals than the plain run;
//   - a kick that has begun is waited for; in the phase set everybody stands.
//
// Turns lie on multiples of their period, for both sides alike: neither side nor a mirrored game is ahead, and many
// ticks are nobody's. The ball, contacts and the referee are judged in every tick for everybody.
// scripts/bench equivalence shows how near games come to those of the plain run.
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

/// [ticks] from `now` until the body moves on.
inline Tick until_move(const Body& body, Tick now) { return static_cast<std::uint8_t>(body.moved - now); }

/// The world to look at: in a state, a robot that rests is where its next turn begins; here it is on the way there, as
/// far as it has rested. [field]
World between_turns(const State& state);

}  // namespace sim
