// States for tests: random ones, mirrored ones, and ones with exchanged sides.
#pragma once

#include <cstdint>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::test {

/// Returns a state whose fields hold random possible values, most of which no game has. The result depends only on
/// `seed`.
State scrambled(std::uint64_t seed);

/// Returns the state mirrored at the x axis: left is right and y is -y.
State mirrored(const State& state);

/// Return the same game with the names of the sides exchanged: the home robots are the away robots, in the same places.
State exchanged(const State& state);
Params exchanged(const Params& params);

/// Returns the state without values that have no effect: the foot of a finished kick, and the sign of half a turn.
State as_it_matters(State state);

}  // namespace sim::test
