#include "sim/match/due.h"

#include <algorithm>

#include "sim/match/due_lanes.h"
#include "sim/match/pace.h"

namespace sim {

Due due_in(State& state) {
  const World& world = state.world;
  const Some side = (1u << world.players) - 1;
  // find those in the schedule
  Dates dates{state.schedule, world.tick, side | side << kMaxPlayers};
#pragma GCC unroll 16
  for (int robot = 0; robot < kMaxRobots; ++robot) dates.moved[robot] = world.bodies[robot].moved;
  Due due;
  in_lanes<find_due>(dates, due);
  due.any = due.moves | due.radios;

  // a removed robot has no turn until it enters again
  for_each_of(due.moves, [&](int robot) {
    if (on_field(world.bodies[robot])) return;
    state.schedule.turn[robot] = kNever;
    due.moves &= ~(1u << robot);
  });
  due.turns &= due.moves;
  return due;
}

Tick next_tick(const State& state, const Due& due) {
  const Schedule& schedule = state.schedule;
  const Tick now = state.world.tick;
  Tick next = due.later;
  for_each_of(due.any, [&](int robot) {
    const Tick move = schedule.turn[robot] == kNever ? kNever : now + until_move(state.world.bodies[robot], now);
    next = std::min({next, move, schedule.radio[robot]});
  });
  return next;
}

}  // namespace sim
