// A robot that walks after a ball, as ground truth and as the robot saw it, with a planted offset between their clocks.
#pragma once

#include <cstdint>

#include "robot/lab/clocks/series.h"
#include "robot/lab/clocks/shared_distance.h"

namespace tests {

/// The plan of a recording.
struct PlantedPlan {
  double seconds = 60;
  bool kicks = true;  // without them the ball lies still and the robot walks to it
  double offset = 0;  // [s] > 0: the robot's clock is ahead
  double drift = 0;   // [s/s]
  std::uint32_t seed = 1;
  double truth_rate = 30;  // [Hz]
};

/// The distance between robot and ball [m].
struct PlantedDistances {
  robot::lab::Series truth;  // error of the ball 1 cm, of the robot 2 cm
  robot::lab::Series seen;   // unknown scale and bias, slow noise of 8 cm at 1.5 m, misses, outliers
};

PlantedDistances planted_distances(const PlantedPlan& plan);

/// Returns the distances of both sides.
robot::lab::SharedDistance shared_distance(const PlantedDistances& distances);

}  // namespace tests
