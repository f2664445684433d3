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
};

/// When robots are due, by their index.
struct Schedule {
  Tick next = 0;                       // nobody is before: most ticks cost one look
  Tick turn[kMaxRobots] = {};          // when it perceives and decides (sim/match/pace.h); kNever: is removed
  Tick radio[kMaxRobots] = {};         // when its packet arrives; with none on the way: when it may send again
  std::uint8_t lag[kMaxRobots] = {};   // [ticks] from its last turn to the next
  std::uint8_t lost[kMaxRobots] = {};  // whom the packet on its way does not reach: bit i is beliefs.mates[i]
};

struct State {
  World world;
  Schedule schedule;
  referee::Book book;
  referee::GameCounts counts;
  Robot robots[kMaxRobots];  // by the same index as the bodies
};
static_assert(std::is_trivially_copyable_v<State>);
static_assert(sizeof(State) <= 8192);

}  // namespace sim
