// All years: when nobody has touched the ball for Rules::stuck_global, play restarts with a kick-off. It goes to the
// side that did not touch the ball last. Without a touch since the last kick-off or set play, it goes to the side that
// did not have that one.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::global_stuck {

inline bool due(const Court& court) {
  return court.book.ball_free && court.rules.stuck_global > 0 &&
         court.world.tick - court.book.last_touch_tick >= ticks(court.rules.stuck_global);
}

inline void apply(Court& court) {
  const Side kicking = other(court.book.last_touch);
  report(court, Event::Kind::global_stuck, kicking, kNobody, court.world.ball.position);
  begin_kick_off(court, kicking, court.world.tick);
}

}  // namespace sim::referee::global_stuck
