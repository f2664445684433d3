// All years: a robot that walks off the carpet by more than Rules::leaving_distance is removed.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::leaving_field {

inline bool due(const Court& court, int robot) {
  const Vec2 at = court.world.bodies[robot].position;
  const float beyond = court.field.border + court.rules.leaving_distance;
  return std::abs(at.x) > court.field.length / 2 + beyond || std::abs(at.y) > court.field.width / 2 + beyond;
}

inline void apply(Court& court, int robot) { remove_robot(court, robot, Event::Kind::leaving); }

}  // namespace sim::referee::leaving_field
