// Since 2018: a ball that a defender put over its own goal line lies in the corner of the field, on the side where it
// went out, for a corner kick of the attackers.
#pragma once

#include "sim/referee/crossing.h"

namespace sim::referee::corner_kick {

inline bool due(const Court& court, const Crossing& crossing) {
  return crossing.goal_line && court.book.last_touch == defender_of(court, crossing);
}

inline void apply(Court& court, const Crossing& crossing) {
  const Vec2 at{crossing.end * court.field.length / 2, crossing.line * court.field.width / 2};
  begin_set_play(court, SetPlay::corner_kick, Event::Kind::corner_kick, other(defender_of(court, crossing)), at);
}

}  // namespace sim::referee::corner_kick
