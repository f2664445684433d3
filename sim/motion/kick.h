// Kicks from the table. Internal to sim/motion.
#pragma once

#include "sim/motion/command.h"
#include "sim/motion/motion.h"
#include "sim/world/world.h"

namespace sim::motion {

/// [m] With the effect kick_whiff off, any ball that lies before the robot and nearer than this is hit.
inline constexpr float kReach = 0.25f;

/// Stops the body and begins the kick that the command names.
void begin_kick(const Command& command, Tick now, Body& body);

/// Goes on with the kick for at most `left` ticks, up to its end; the foot meets the ball on the way. Returns how many
/// ticks it took, at least one.
Tick kick(const MotionParams& params, int robot, Tick now, Tick left, World& world);

}  // namespace sim::motion
