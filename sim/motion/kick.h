// Kicks from the table. Internal to sim/motion.
#pragma once

#include "sim/motion/command.h"
#include "sim/motion/motion.h"
#include "sim/world/world.h"

namespace sim::motion {

/// [m] Without the effect kick_whiff, a kick hits every ball in front of the robot that is nearer than this.
inline constexpr float kReach = 0.25f;

/// Stops the body and begins the kick of the command.
void begin_kick(const Command& command, Tick now, Body& body);

/// Continues the kick for at most `left` ticks, up to its end; the foot hits the ball on the way.
/// Returns the ticks used, at least one.
Tick kick(const MotionParams& params, int robot, Tick now, Tick left, World& world);

}  // namespace sim::motion
