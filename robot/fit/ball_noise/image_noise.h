// The noise of the ball's place in images, as the simulator has it: errors of elevation and bearing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/ball_noise/ball_places.h"
#include "robot/fit/figure.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Facts of the models that are not fitted.
struct ImageFacts {
  double height = 0;        // [m] of the camera above the middle of the ball
  double pixels = 0;        // [rad] error by the pixels, on each axis
  double far_range = 0;     // [m] of the detection; percepts at twice that are dropped
  double deceleration = 0;  // [m/s²] of a rolling ball
};
ImageFacts image_facts(const sim::Models& base);

/// Returns the angle [rad] of a place below the horizon, `distance` [m] away along the ground.
double elevation_at(double distance, double height);
/// Returns the distance [m] at such an angle [rad], infinite at the horizon and above.
double distance_at(double elevation, double height);

/// The errors of one percept of a ball that lies. Those of elevation are normal at any distance, those of the
/// distance are not.
struct ImageError {
  std::size_t place = 0;      // index of the percept
  std::size_t recording = 0;  // of the robot
  bool standing = false;
  double distance = 0;                                  // [m] true
  double elevation = 0, bearing = 0;                    // [rad] seen - true; NaN: not usable
  double of_elevation = 0;                              // [rad] standard deviation by the truth's error and the clock
  double of_bearing = 0;                                // [rad] likewise
  double elevation_by_clock = 0, bearing_by_clock = 0;  // [rad] the clock's part of them, one error for all images
};

/// The three parameters, or others with the same meaning.
struct ImageNoise {
  double tilt = 0, tilt_walking = 0, roll = 0;  // [rad]
};

/// One fitted parameter.
struct NoiseParameter {
  bool known = false;               // false: too few images or passes
  double value = 0, deviation = 0;  // [rad] and one standard deviation
  std::size_t passes = 0, images = 0;
  double nearest = 0, farthest = 0;  // [m]
};

/// The mean error of one recording.
struct ImageBias {
  double elevation = 0, bearing = 0;  // [rad] medians
  std::size_t images = 0;
};

/// The judgement of a noise by images held out.
struct NoiseScore {
  std::size_t images = 0;
  double covered = 0;    // share of the images in the region of 90 %
  double log_score = 0;  // mean logarithm of the density [1/rad²]
};

/// Scores of images held out: those of each recording in turn, or of each fifth of the passes of a single recording.
struct NoiseScores {
  NoiseScore fitted[2], other[2];  // moving, standing
};

struct ImageNoiseFit {
  std::vector<ImageError> errors;  // of all usable images
  std::vector<Group> passes;       // of these errors
  std::vector<ImageBias> biases;   // of each recording
  NoiseParameter tilt, tilt_walking, roll;
  NoiseScores scores;            // of images with a usable elevation and bearing
  std::size_t moving = 0;        // percepts of balls that moved: the latency displaces them
  std::size_t without_gait = 0;  // percepts of robots that did not report their motion, or were down
  std::size_t beyond = 0;        // percepts near the horizon: some of their like were lost behind it
  std::size_t close = 0;         // percepts whose error would be mostly that of the truth
  std::size_t turning = 0;       // percepts whose error would be mostly that of the clock
};

/// Fits the noise to percepts of balls that lie, around the median of each recording. The errors of truth and clock
/// have known variances, which are subtracted; false balls hardly count. A parameter is not known with fewer than 40
/// images in 8 passes. Judges the fit beside another noise.
ImageNoiseFit fit_image_noise(const BallPlaces& places, const ImageFacts& facts, const ImageNoise& other);

}  // namespace robot::fit
