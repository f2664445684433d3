// Falling and getting up. Internal to sim/motion.
#pragma once

#include <span>

#include "sim/motion/motion.h"
#include "sim/world/world.h"

namespace sim::motion {

/// Lets an upright body fall with the probability of its ticks.
void perhaps_fall(const MotionParams& params, const Mover& mover);
/// Does the same for each robot of a list.
void perhaps_fall(const MotionParams& params, std::span<const Mover> movers);

/// Lets the body lie or get up for at most `left` ticks, up to the next change. Returns the ticks used, at least one.
Tick lie(const MotionParams& params, int robot, Tick now, Tick left, World& world);

}  // namespace sim::motion
