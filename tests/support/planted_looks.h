// Balls in view of a robot with a known detection, seen or not.
#pragma once

#include <cstdint>

#include "robot/fit/visibility/logistic.h"
#include "robot/fit/visibility/looks.h"
#include "robot/fit/visibility/sights.h"
#include "sim/match/params.h"

namespace robot::tests {

/// Returns models with a Nao's camera, noise and detection: 0.9 up to 3.5 m, 0.15 at 6 m, and 0.015 false balls a second.
sim::Models planted_base();

struct PlantedDetections {
  double near = 0.9, far = 0.15, near_range = 3.5, far_range = 6;  // as sim::perception::Detection
  double nearest = 0.4, farthest = 6.5;                            // [m] of the passes
  double truth_error = 0.02;                                       // [m] of each distance
  double hidden = 0.2;                                             // share of the passes
  std::size_t passes = 200, images = 50;                           // in each pass
};

/// Returns the sights of two recordings, the same for the same seed.
fit::Sights planted_detections(const PlantedDetections& planted, std::uint64_t seed);

/// Returns sights of one recording that follow the weights of a logistic model, 40 in each pass.
fit::Sights planted_logistic(const fit::Logistic::Features& weights, std::size_t passes, std::uint64_t seed);

struct PlantedLooks {
  double false_per_second = 0.05;
  double noise = 0.02;          // [rad] of percepts, in both directions
  double heading_error = 0.05;  // [rad] of the truth
  double seconds = 1000;
  bool mirrored = false;  // left and right are exchanged
};

/// Returns the images of one robot. It looks about, sees a ball in view in nine of ten images, and false balls as the simulator
/// draws them.
fit::Looks planted_looks(const PlantedLooks& planted, std::uint64_t seed);

}  // namespace robot::tests
