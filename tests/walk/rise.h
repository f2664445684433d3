// Trials of getting up: a robot lies on the ground, the guardian gets it up.
#pragma once

#include <cstdint>

#include "robot/nao/guardian/get_up.h"
#include "tests/walk/drawn_robot.h"

namespace robot::nao {

/// How a robot hits the ground.
struct Drop {
  PerJoint<float> limbs{};     // [rad]
  double roll = 0, pitch = 0;  // [rad] of the torso: about its x axis, then about the y axis of the world
};

/// Draws a drop onto that side. The limbs are anywhere around those of a robot that has tucked them in.
Drop draw_drop(Lying side, std::uint64_t seed);

/// The result of one trial.
struct Rise {
  bool stood = false;  // for two seconds
  int failed = 0;      // attempts before that, with falls of a robot that stood
  double seconds = 0;  // from the beginning of the first attempt until it stood
};

/// Drops the robot of this seed and orders the guardian to get it up.
Rise rise(walk::Servos servos, std::uint64_t seed, Lying side);

}  // namespace robot::nao
