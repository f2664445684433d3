// Squatting to block the ball. Internal to sim/motion.
#pragma once

#include "sim/motion/motion.h"
#include "sim/world/world.h"

namespace sim::motion {

inline bool squats(const Body& body) {
  return body.doing == Body::Doing::crouching || body.doing == Body::Doing::squatting;
}

/// Stops the body and begins to go down.
void begin_squat(Tick now, Body& body);

/// Goes down, or stays down and comes up again, for at most `left` ticks, up to the next change. Returns how many ticks
/// it took, at least one.
Tick squat(const MotionParams& params, Tick now, Tick left, Body& body);

}  // namespace sim::motion
