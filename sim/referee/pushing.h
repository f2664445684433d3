// All years: a robot that runs into another one for Rules::pushing_time is removed. The pushed robot stays.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::pushing {

inline bool due(const Court& court, int robot) {
  // the most likely answer first: hardly any body pushes
  const std::uint8_t pushing = court.world.bodies[robot].pushing;
  constexpr float kUnitsPerSecond = kTicksPerSecond / kPushingUnit;
  return pushing > 0 && court.rules.pushing_time > 0 &&
         static_cast<float>(pushing) >= kUnitsPerSecond * court.rules.pushing_time;
}

inline void apply(Court& court, int robot) { remove_robot(court, robot, Event::Kind::pushing); }

}  // namespace sim::referee::pushing
