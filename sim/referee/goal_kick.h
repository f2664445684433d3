// Since 2018: when an attacker puts the ball over the goal line, the defenders have a goal kick. The ball lies at the
// corner of the goal area on the side where it went out.
#pragma once

#include "sim/referee/crossing.h"

namespace sim::referee::goal_kick {

inline bool due(const Court& court, const Crossing& crossing) {
  return crossing.goal_line && court.book.last_touch != defender_of(court, crossing);
}

inline void apply(Court& court, const Crossing& crossing) {
  const Vec2 at = field::goal_kick_place(court.field, crossing.end, crossing.line);
  begin_set_play(court, SetPlay::goal_kick, Event::Kind::goal_kick, defender_of(court, crossing), at);
}

}  // namespace sim::referee::goal_kick
