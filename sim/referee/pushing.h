// All years: a robot that keeps running into another is removed; who is pushed stays.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::pushing {

inline bool due(const Court& court, int robot) {
  // a body counts in fifths of a second, and hardly any does
  const std::uint8_t pushing = court.world.bodies[robot].pushing;
  return pushing > 0 && court.rules.pushing_time > 0 && static_cast<float>(pushing) >= 5 * court.rules.pushing_time;
}

inline void apply(Court& court, int robot) { remove_robot(court, robot, Event::Kind::pushing); }

}  // namespace sim::referee::pushing
