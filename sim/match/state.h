// The state of a game: everything that changes, in one plain struct.
//
// A copy is a snapshot: rewind, what-if, rollouts and replay are copies of a State. Everything that stays constant is
// in Params (sim/match/params.h).
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

/// One robot without its body, which is in the world.
struct Robot {
  motion::Command command;          // the newest command, in force until the next one
  agent::Beliefs beliefs;           // of ball, own pose, teammates and opponents
  agent::Mind mind;                 // the behaviour's memory between decisions
  perception::Cognition cognition;  // hidden errors of odometry and pose, and the packet on the air
};

/// The ticks in which robots are due, by index.
struct Schedule {
  Tick next = 0;                       // earliest tick with anything due, so that most ticks cost one comparison
  Tick turn[kMaxRobots] = {};          // next perception and decision (sim/match/pace.h); kNever: removed
  Tick radio[kMaxRobots] = {};         // arrival of the packet on the air; without one: earliest next packet
  std::uint8_t lag[kMaxRobots] = {};   // [ticks] from the last turn to the next
  std::uint8_t lost[kMaxRobots] = {};  // receivers that lose the packet on the air: bit i is beliefs.mates[i]
};

/// The whole state of a game.
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
