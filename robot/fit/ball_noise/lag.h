// The age of the ball's place in images, from balls that roll.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/ball_noise/ball_places.h"
#include "robot/fit/ball_noise/image_noise.h"

namespace robot::fit {

/// A rolling ball in one image.
struct LagImage {
  std::size_t place = 0;                    // index of the percept or belief
  std::size_t recording = 0;                // of the robot
  bool has_elevation = false;               // far enough from the horizon
  double elevation = 0;                     // [rad] seen - true, without the median error of balls that lie
  double bearing = 0;                       // [rad] likewise
  double of_elevation = 0, of_bearing = 0;  // [rad] standard deviations of both, of percept and truth
  double along = 0;                         // [m] error of the place along the ball's true velocity; NaN: not known
};

/// The lag by the recordings of one clock.
struct ClockLag {
  std::string clock;                // BallRecording::clock
  double value = 0, deviation = 0;  // [s] and one standard deviation by the luck of passes
  double clock_deviation = 0;       // [s]
  std::size_t passes = 0;
};

struct LagFit {
  bool known = false;
  double value = 0;      // [s] > 0: the ball is shown where it was before
  double deviation = 0;  // [s] one standard deviation, of luck and clocks
  std::vector<LagImage> images;
  std::vector<Group> passes;        // of the images
  std::vector<ClockLag> clocks;     // one for each clock
  std::size_t by_ball = 0;          // images of recordings whose clock was compared by the ball itself
  std::size_t bent = 0;             // images of balls that were touched around that moment
  std::size_t slow = 0;             // images of balls that were slower than 0.4 m/s
  double slowest = 0, fastest = 0;  // [m/s] of the balls in `images`
  double error = 0,
         uncorrected = 0;  // [m] median |error| along the motion, in passes held out: after and without the lag
};

/// Fits the lag of percepts or beliefs. The ball of an image is where it was `lag` before: its elevation and bearing
/// are compared with those of the truth there, without a true heading only the elevation. Both axes count by their
/// noise, which balls that lie show; false balls hardly count. The error of a clock adds fully to the lag of its
/// recordings; several clocks have independent errors.
LagFit fit_lag(const std::vector<BallPlace>& places, const std::vector<BallRecording>& recordings,
               const ImageFacts& facts, const ImageNoise& usual);

}  // namespace robot::fit
