// Turning heads. Internal to sim/motion.
#pragma once

#include <span>

#include "sim/motion/motion.h"

namespace sim::motion {

/// Turns the head of a robot whose body has moved already.
void turn_head(const MotionParams& params, const Mover& mover);

/// Turns the heads of robots with the same model whose bodies have moved already.
void turn_heads(const MotionParams& params, std::span<const Mover> movers);

}  // namespace sim::motion
