// The head. Internal to sim/motion.
#pragma once

#include <span>

#include "sim/motion/model.h"
#include "sim/motion/motion.h"

namespace sim::motion {

/// Returns how far the head may turn to each side at this pitch without touching a shoulder [rad] (Northern Bites,
/// corpus/Kinematics.h).
float yaw_limit_at(const Head& head, float pitch);

/// Turns the heads of robots whose bodies have moved already.
void turn_heads(const MotionParams& params, std::span<const Mover> movers);

}  // namespace sim::motion
