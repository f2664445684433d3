// A ground truth in which a ball rebounds off robots and goal posts, and robots walk into it, with known parameters.
#pragma once

#include <cstddef>
#include <cstdint>

#include "robot/lab/clocks/truth_record.h"

namespace robot::tests {

struct PlantedTouches {
  double robot_restitution = 0.5, post_restitution = 0.6;
  double push_deviation = 0.4;  // [rad]
  double deceleration = 0.3;    // [m/s²] of the ball
  double truth_error = 0.02;    // [m] one standard deviation of each place
  std::size_t rebounds = 30, posts = 0, pushes = 0;
  double mirrored = 1;  // -1: every place with the other sign of y
};

/// Returns the truth of one touch after the other, 30 images a second; the same for the same seed. A robot's reach is 0.15 m, the
/// field is that of 9 m x 6 m. Pushes follow sim/world/bounce.cpp.
lab::TruthRecord planted_touches(const PlantedTouches& planted, std::uint64_t seed);

}  // namespace robot::tests
