// Walking with a speed or to a destination. Internal to sim/motion.
#pragma once

#include <cstddef>
#include <span>

#include "sim/motion/command.h"
#include "sim/motion/errand.h"
#include "sim/motion/motion.h"
#include "sim/world/world.h"

namespace sim::motion {

inline constexpr float kArrived = 0.01f;      // [m] below this it has arrived
inline constexpr float kArrivedTurn = 0.03f;  // [rad] likewise

/// The rest of one robot's walk.
struct Walker {
  const Command* command;
  World* world;
  int robot;
  Tick now;
  Tick left;  // [ticks] from `now` on
  Errand errand;

  Body& body() const { return world->bodies[robot]; }
};

/// Lets a robot stand, start, walk or stop for its ticks.
void walk_alone(const MotionParams& params, Walker walker);

/// Does the same for up to kLanes robots with the same model, but perhaps only for a part of their ticks. Keeps those
/// with a rest, at the front, and returns their number.
std::size_t walk_together(const MotionParams& params, std::span<Walker> walkers);

}  // namespace sim::motion
