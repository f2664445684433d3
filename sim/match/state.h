// The state of a game: everything that changes, in one plain struct.
//
// Copying it is the snapshot; rewind, what-if, rollouts and replay are copies. What does not change is in Params
// (sim/match/params.h).
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/motion/command.h"
#include "sim/perception/cognition.h"
#include "sim/referee/book.h"
#include "sim/world/world.h"

namespace sim {

/// One robot but for its body, which is in the world.
struct Robot {
  motion::Command command;          // the last one, in force until the next
  agent::Beliefs beliefs;           // what it thinks is so
  agent::Mind mind;                 // what it remembers
  perception::Cognition cognition;  // how wrong it is
  std::uint8_t rest = 0;            // [ticks] until it perceives, decides and moves again; 0: now (sim/match/pace.h)
  std::uint8_t lag = 1;             // [ticks] since it last did
};

struct State {
  World world;
  referee::Book book;
  referee::Tally tally;
  Robot robots[kMaxRobots];  // by the same index as the bodies
};
static_assert(std::is_trivially_copyable_v<State>);
static_assert(sizeof(State) <= 8192);

}  // namespace sim
