// How robots hit the ground.
#pragma once

#include <cstdint>

#include "robot/nao/guardian/get_up.h"

namespace robot::nao {

/// A robot in the air, just before it hits the ground.
struct Drop {
  PerJoint<float> limbs{};     // [rad]
  double roll = 0, pitch = 0;  // [rad] of the torso: about its x axis, then about the y axis of the world
};

/// Draws a drop onto that side. The limbs are anywhere around those of a robot that has tucked them in.
Drop draw_drop(Lying side, std::uint64_t seed);

}  // namespace robot::nao
