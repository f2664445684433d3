// Robots that see a ball with known noise and lag, beside a ground truth with an error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "robot/fit/ball_noise/ball_places.h"

namespace robot::tests {

/// The errors of robots and truth. Each episode of a recording lasts six seconds: the ball lies, then it rolls. In
/// every other one the robot walks.
struct PlantedSights {
  double tilt = 0.015, tilt_walking = 0.028, roll = 0.018;  // [rad]
  double pixels = 0.00308;                                  // [rad] of each axis
  double height = 0.4;                                      // [m] of the camera above the ball's middle
  double elevation_bias = 0, bearing_bias = 0;              // [rad]
  double lag = 2 / 30.;                                     // [s] of the percepts
  double false_balls = 0.002;                               // share of percepts
  double truth_error = 0.02, heading_error = 0.01;          // [m], [rad] of each place in the truth
  double late = 0;                                          // [s] error of each clock, one standard deviation
  double nearest = 1, farthest = 4;                         // [m] of the ball
  bool has_heading = true, has_gait = true;                 // false: neither the truth nor the robot has them
  std::size_t recordings = 3, episodes = 20;                // of each recording
};

/// Some recordings, each of a game of its own.
struct SightsOfGames {
  std::vector<std::unique_ptr<fit::WatchedRobot>> robots;
  std::vector<fit::SeenBalls> seen;  // of these robots
};

/// Returns the same for the same seed. Beliefs are the percepts 50 ms later.
SightsOfGames planted_sights(const PlantedSights& planted, std::uint64_t seed);

}  // namespace robot::tests
