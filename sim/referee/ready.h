// All years: in READY the robots walk to their places, for 45 s at most. READY ends early when all robots on the field
// have stood still for two seconds since they received it (as B-Human's simulated referee does). SET follows.
#pragma once

#include "sim/referee/in_set.h"

namespace sim::referee::ready {

inline constexpr float kStill = 2;  // [s] all robots have to stand

inline bool anybody_moves(const Court& court) {
  bool moves = false;
  for_each_robot(court.world.players, [&](int robot) {
    const Doing doing = court.world.bodies[robot].doing;
    moves |= doing != Doing::standing && doing != Doing::removed;
  });
  return moves;
}

/// Notes since when all robots stand. Puts the ball at the centre when the robots
/// receive READY. Call it once a tick.
inline void watch(Court& court) {
  Book& book = court.book;
  if (book.phase != Phase::ready) return;
  if (court.world.tick == book.told_phase_since) place_ball(court, {});
  if (court.world.tick > book.still_since && anybody_moves(court)) book.still_since = court.world.tick;
}

inline bool due(const Court& court) {
  return court.book.phase == Phase::ready && (court.world.tick >= court.book.still_since + ticks(kStill) ||
                                              in_phase(court) >= ticks(court.rules.ready_duration));
}

inline void apply(Court& court) {
  begin_phase(court, Phase::set);
  place_ball(court, {});
  report(court, Event::Kind::set, court.book.kicking, kNobody, {});
  for_each_robot(court.world.players, [&](int robot) {
    if (in_set::due(court, robot)) in_set::apply(court, robot);
  });
}

}  // namespace sim::referee::ready
