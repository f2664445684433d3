// A look: one perception of one robot. Looks of many robots and games are computed together (sim/math/lanes.h).
#pragma once

#include <cstddef>

#include "sim/agent/beliefs.h"
#include "sim/math/tick.h"
#include "sim/perception/cognition.h"
#include "sim/world/world.h"

namespace sim::perception {

/// The most looks that are computed together.
inline constexpr std::size_t kMostLooks = 64;

/// One perception, `steps` ticks after the robot's last one: what it sees, and what it changes.
struct Look {
  const World* world;
  agent::Beliefs* beliefs;
  Cognition* cognition;
  int robot;
  Tick steps;

  const Body& body() const { return world->bodies[robot]; }
};

}  // namespace sim::perception
