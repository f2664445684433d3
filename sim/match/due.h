// The robots with something to do in a tick.
#pragma once

#include <bit>
#include <cstdint>

#include "sim/match/state.h"

namespace sim {

/// A set of robots, one bit per index.
using Some = std::uint32_t;

template <class See>
void for_each_of(Some robots, See&& see) {
  for (; robots != 0; robots &= robots - 1) see(std::countr_zero(robots));
}

/// The robots of one game with something to do in a tick.
struct Due {
  Some moves = 0;       // move on; all are on the field
  Some turns = 0;       // perceive and decide before they move
  Some radios = 0;      // their packet arrives or may be sent
  Some any = 0;         // all of these, and robots that were removed since their last turn
  Tick later = kNever;  // next tick in which one of the others has something to do
};

/// Returns the robots that are due now. Takes the turns of removed robots until they enter again.
Due due_in(State& state);

/// Returns the next tick in which any robot has something to do. `due` are the robots that have just done it.
Tick next_tick(const State& state, const Due& due);

}  // namespace sim
