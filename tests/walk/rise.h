// Trials of getting up: a robot lies on the ground, its guardian gets it up.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/walk/drawn_robot.h"
#include "tests/walk/drop.h"

namespace robot::nao {

/// The result of one trial.
struct Rise {
  bool stood = false;  // for two seconds
  int failed = 0;      // attempts before that, with falls of a robot that stood
  double lay = 0;      // [s] before the first attempt
  double seconds = 0;  // from the beginning of the first attempt until it stood

  bool at_once() const { return stood && failed == 0; }
};

/// Drops the robot of this seed and commands it to get up.
Rise rise(walk::Servos servos, std::uint64_t seed, Lying side);
/// Does so with `robots` robots of the seeds from `first_seed` on.
std::vector<Rise> rises(walk::Servos servos, std::uint64_t first_seed, int robots, Lying side);

}  // namespace robot::nao
