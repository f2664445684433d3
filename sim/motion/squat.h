// The squat that blocks the ball. Internal to sim/motion.
#pragma once

#include "sim/motion/motion.h"
#include "sim/world/world.h"

namespace sim::motion {

inline bool squats(const Body& body) {
  return body.doing == Body::Doing::crouching || body.doing == Body::Doing::squatting;
}

/// Stops the body and begins to go down.
void begin_squat(Tick now, Body& body);

/// Lets the body go down, stay down or come up for at most `left` ticks, up to the next change. Returns the ticks used,
/// at least one.
Tick squat(const MotionParams& params, Tick now, Tick left, Body& body);

}  // namespace sim::motion
