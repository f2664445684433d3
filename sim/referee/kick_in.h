// Since 2018: a ball that a side put over a touch line lies where it crossed the line for a kick-in of the other side.
#pragma once

#include "sim/referee/crossing.h"

namespace sim::referee::kick_in {

inline bool due(const Court&, const Crossing& crossing) { return !crossing.goal_line; }

inline void apply(Court& court, const Crossing& crossing) {
  const float end = court.field.length / 2;
  const Vec2 at{std::clamp(crossing.at.x, -end, end), crossing.line * court.field.width / 2};
  begin_set_play(court, SetPlay::kick_in, Event::Kind::kick_in, other(court.book.last_touch), at);
}

}  // namespace sim::referee::kick_in
