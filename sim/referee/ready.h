// All years: in ready robots walk to their places, for 45 s at most. It ends early when everybody on the field has
// stood still for two seconds, since robots know of it (B-Human's simulated referee). Then comes set.
#pragma once

#include "sim/referee/in_set.h"

namespace sim::referee::ready {

// [s] everybody has to stand
inline constexpr float kStill = 2;

inline bool anybody_moves(const Court& court) {
  bool moves = false;
  for_each_robot(court.world.players, [&](int robot) {
    const Doing doing = court.world.bodies[robot].doing;
    moves |= doing != Doing::standing && doing != Doing::removed;
  });
  return moves;
}

/// Notes since when everybody stands; puts the ball at the centre when robots know that it is ready. Once a tick.
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
  tell(court, Event::Kind::set, court.book.kicking, kNobody, {});
  for_each_robot(court.world.players, [&](int robot) {
    if (in_set::due(court, robot)) in_set::apply(court, robot);
  });
}

}  // namespace sim::referee::ready
