// Since 2018: when a defender puts the ball over its own goal line, the attackers have a corner kick. The ball lies in
// the corner of the field on the side where it went out.
#pragma once

#include "sim/referee/crossing.h"

namespace sim::referee::corner_kick {

inline bool due(const Court& court, const Crossing& crossing) {
  return crossing.goal_line && court.book.last_touch == defender_of(court, crossing);
}

inline void apply(Court& court, const Crossing& crossing) {
  const Vec2 at = field::corner_kick_place(court.field, crossing.end, crossing.line);
  begin_set_play(court, SetPlay::corner_kick, Event::Kind::corner_kick, other(defender_of(court, crossing)), at);
}

}  // namespace sim::referee::corner_kick
