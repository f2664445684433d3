// The rates at which a robot perceives, decides and moves.
//
// With Pace::thinned a robot does all three once for several ticks: one perception of all their images, one decision,
// one longer move. The number of ticks depends on how soon the robot could matter:
//   - A walking robot finishes its step before its legs obey a new command (sim/motion/rhythm.h), so it decides when a
//     step begins. Near the ball, or near its path in the next second, it decides with each step, elsewhere with every
//     second step. Within 0.8 m of the ball it decides once more in between: without that, games have 4 % more shots
//     than with Pace::every_tick. Next to the ball or to another robot the body moves through the step in pieces,
//     because contacts are resolved in every tick.
//   - A standing robot decides in every second tick while the ball is near or comes near. With longer waits robots
//     block too late, and games without noise have 10 % more goals than with Pace::every_tick.
//   - A kicking robot waits for the contact with the ball. In the phase SET all robots stand.
//
// Turns lie on multiples of their period, equally for both sides. So neither side nor a mirrored game has an advantage,
// and in many ticks no robot has a turn. The ball, contacts and the referee run in every tick.
// `scripts/bench equivalence` compares such games with games of Pace::every_tick.
#pragma once

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim {

/// The times that a robot waits [ticks], at least 1.
struct Wait {
  Tick turn;  // until its next turn
  Tick move;  // until its body moves on, at most `turn`
};

/// Returns the robot's waiting times. Call it after the robot's decision and before any body moves. The result does not
/// depend on the order of the robots.
Wait wait_of(const Params& params, const State& state, int robot);

/// Returns the time from `now` until the body moves on [ticks].
inline Tick until_move(const Body& body, Tick now) { return static_cast<std::uint8_t>(body.moved - now); }

/// Returns the world for display [field]. In a State, a body that moves in long pieces is already at the end of its
/// piece; here it is interpolated between start and end.
World between_turns(const State& state);

}  // namespace sim
