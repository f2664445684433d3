// Kicks of a robot with known parameters, in a ground truth with an error.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/fit/kicks/kick_model.h"
#include "robot/fit/kicks/kick_run.h"

namespace robot::tests {

struct PlantedKicks {
  fit::KickModel model{
      .speed = 1.4, .range_deviation = 0.2, .direction = 0.05, .direction_deviation = 0.12, .partial = 0};
  double spread = 3;          // factor on the deviation of the direction after the weakest hit
  double delay = 0.6;         // [s]
  double deceleration = 0.3;  // [m/s²]
  double truth_error = 0.02;  // [m] one standard deviation of each place
  std::size_t kicks = 50;
};

/// A robot that kicks a ball every eight seconds, with either foot.
struct KickedBalls {
  lab::TruthRecord truth;
  lab::Path robot;
  std::vector<fit::KickRun> runs;
};

/// Returns the same for the same seed. The kind of the kicks is "forward", the ball lies at (0.18, 0.05) m before each.
KickedBalls kicked_balls(const PlantedKicks& planted, std::uint64_t seed);

}  // namespace robot::tests
