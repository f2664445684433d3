// Trials of getting up: a robot lies on the ground, its guardian gets it up.
#pragma once

#include <cstdint>

#include "tests/walk/drawn_robot.h"
#include "tests/walk/drop.h"

namespace robot::nao {

/// The result of one trial.
struct Rise {
  bool stood = false;  // for two seconds
  int failed = 0;      // attempts before that, with falls of a robot that stood
  double seconds = 0;  // from the beginning of the first attempt until it stood
};

/// Drops the robot of this seed and commands it to get up.
Rise rise(walk::Servos servos, std::uint64_t seed, Lying side);

}  // namespace robot::nao
