// 2012: only the goalkeeper may be in its own goal area. A field player there is removed.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::illegal_defender {

inline bool due(const Court& court, int robot) {
  if (!court.rules.illegal_defender || player_of(robot) == 1) return false;
  const Vec2 at = court.world.bodies[robot].position;
  const float back = -ahead(court, side_of(robot), at);
  const float line = court.field.length / 2;
  return back > line - court.field.goal_area_length && back < line + court.field.goal_depth &&
         std::abs(at.y) < court.field.goal_area_width / 2;
}

inline void apply(Court& court, int robot) { remove_robot(court, robot, Event::Kind::illegal_defender); }

}  // namespace sim::referee::illegal_defender
