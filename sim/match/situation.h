// Situations: states in the middle of a game, from which what-ifs, tests, the signature and benches start.
#pragma once

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim {

/// Starts play in a situation. The caller has placed ball and bodies, and has set clock, half and score if they matter.
/// Every robot on the field enters: all it knows is roughly where it stands.
void start_play(const Params& params, State& state);

/// Gives every robot on the field a belief about the ball: seen at tick `seen`, with a standard deviation of
/// `deviation` [m] and [m/s] along each axis. All robots have just sent a packet about
/// it. Believed poses stay unchanged.
void know_ball(State& state, Tick seen, float deviation);

/// Returns a random situation in play: robots at random places without overlaps, and a ball with a speed of 0 .. 2
/// [m/s]. Draws Draw::situation with `key`, which is also the key of the game.
State random_situation(const Params& params, RandomKey key);

}  // namespace sim
