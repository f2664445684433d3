// Balls in images of a pinhole camera with known parameters, as a robot that walks about would see them.
#pragma once

#include <cstdint>

#include "robot/fit/ball_distance/sizes.h"

namespace robot::tests {

/// The camera and its errors. The defaults are those of a Nao of 2012 that looks at the ball of that year. Images have 640
/// pixels (shared/facts/ground_truth.md section 6: 373 px of focal length in 320 pixels, ball of 3.25 cm).
struct PlantedBalls {
  double scale = 24.2;                             // [m px] focal length by radius
  double offset = 0.7;                             // [px]
  double height = 0.41;                            // [m] of the camera above the ball's middle
  double nearest = 0.5, farthest = 3;              // [m]
  double radius_error = 0.7, radius_share = 0.02;  // [px], and of the radius: one standard deviation
  double truth_error = 0.02;                       // [m] one standard deviation of each true distance
  double late = 0;                                 // [s] error of the clock
  double occluded = 0.03;                          // share of balls that look smaller
  std::size_t passes = 23, images = 20;            // in each pass
};

/// Returns the balls of one recording, the same for the same seed.
fit::BallSizes planted_balls(const PlantedBalls& planted, std::uint64_t seed);

}  // namespace robot::tests
