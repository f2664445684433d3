// States for tests: any numbers, mirrored ones, and those in which the sides have changed names.
#pragma once

#include <cstdint>

#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::test {

/// Every field has some possible value, most of them none that a game would have. A function of `seed`.
State scrambled(std::uint64_t seed);

/// As seen in a mirror along the x axis: left is right and y is -y.
State mirrored(const State& state);

/// The same robots do the same in the same places, but those that were home are called away.
State exchanged(const State& state);
Params exchanged(const Params& params);

/// Without what makes no difference: the foot of a kick that is over, and whether half a turn is one to the left or to
/// the right.
State as_it_matters(State state);

}  // namespace sim::test
