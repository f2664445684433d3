// The limits of the head. Internal to sim/motion.
#pragma once

#include "sim/motion/model.h"

namespace sim::motion {

/// Returns how far the head may turn to each side at this pitch without touching a shoulder [rad] (Northern Bites,
/// corpus/Kinematics.h).
float yaw_limit_at(const Head& head, float pitch);

}  // namespace sim::motion
