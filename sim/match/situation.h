// The middle of some game, described or made up: where what-ifs, tests, the signature and benches begin.
#pragma once

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim {

/// Play is on from here: whoever describes a situation has placed ball and bodies, and set the clock, half and score
/// if those matter. Everybody on the field knows roughly where it stands, and nothing else.
void start_play(const Params& params, State& state);

/// Everybody on the field saw the ball at tick `seen`, off by `deviation` [m] and [m/s] along each axis, and has told
/// its team now. Where each believes to stand stays.
void know_ball(State& state, Tick seen, float deviation);

/// Play is on: everybody somewhere on the field, nobody on top of another, the ball rolling at up to 2 m/s. Drawn from
/// the key (event `situation`), for the key's game.
State random_situation(const Params& params, RandomKey key);

}  // namespace sim
