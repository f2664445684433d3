// The head: angles, or a point to look at. Internal to sim/motion.
#pragma once

#include "sim/motion/command.h"
#include "sim/motion/motion.h"
#include "sim/world/body.h"

namespace sim::motion {

/// [rad] How far the head may turn to each side at this pitch without touching a shoulder (NB corpus/Kinematics.h).
float yaw_limit_at(const Head& head, float pitch);

/// Moves the head for `steps` ticks. A point is looked to within 0.02 rad. Where yaw and pitch together would touch a
/// shoulder, the pitch gives way; the yaw waits for it.
void turn_head(const Means& means, const Command& command, Tick steps, Body& body);

}  // namespace sim::motion
