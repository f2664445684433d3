// Walks of a robot whose odometry and localisation have known errors, beside a truth with errors.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/fit/localisation/watched_motion.h"
#include "sim/match/params.h"

namespace robot::tests {

struct PlantedPoses {
  sim::Models models;           // its localisation is planted; flips and falls shift the pose if their effects are on
  double minutes = 20;          // of a robot
  double truth_error = 0.02;    // [m] of each place, each axis
  double heading_error = 0.05;  // [rad] of each heading in the truth
  double late = 0;              // [s] the robot's clock is ahead
  double falls_per_minute = 0;  // while it walks
  double penalties_per_minute = 0;
  bool changes_sides = false;  // at half of the time
  bool attacks_plus = true;    // at first
};

/// Returns the models of a match.
sim::Models match_models();

/// Returns a walk on an empty field: odometry, poses, status, game, head and truth at 30 Hz. It is the same for the same seed.
fit::WatchedMotion planted_pose_walk(const PlantedPoses& planted, std::uint64_t seed);

/// Returns the walks of several robots.
std::vector<fit::WatchedMotion> planted_poses(const PlantedPoses& planted, std::size_t robots, std::uint64_t seed);

}  // namespace robot::tests
