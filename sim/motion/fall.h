// Falling and getting up. Internal to sim/motion.
#pragma once

#include "sim/motion/motion.h"
#include "sim/world/world.h"

namespace sim::motion {

/// Lets an upright body fall, if that is its luck in these ticks.
void perhaps_fall(const MotionParams& params, int robot, Tick now, Tick steps, World& world);

/// Lies and gets up for at most `left` ticks, up to the next change. Returns how many ticks it took, at least one.
Tick lie(const MotionParams& params, int robot, Tick now, Tick left, World& world);

}  // namespace sim::motion
