// Since 2018: when a side puts the ball over a touch line, the other side has a kick-in. The ball lies where it crossed
// the line.
#pragma once

#include "sim/referee/crossing.h"

namespace sim::referee::kick_in {

inline bool due(const Court&, const Crossing& crossing) { return !crossing.goal_line; }

inline void apply(Court& court, const Crossing& crossing) {
  const Vec2 at = field::kick_in_place(court.field, crossing.at.x, crossing.line);
  begin_set_play(court, SetPlay::kick_in, Event::Kind::kick_in, other(court.book.last_touch), at);
}

}  // namespace sim::referee::kick_in
