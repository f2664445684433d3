// Moments at which something changes the ball's velocity, by the truth alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/evidence.h"

namespace robot::fit {

/// A robot at a moment.
struct Toucher {
  std::string robot;
  double x = 0, y = 0;              // [m, field] place
  double deviation = 0;             // [m] of the place
  double speed_x = 0, speed_y = 0;  // [m/s, field] over 0.25 s before and after
  double speed_deviation = 0;       // [m/s]
  double drift_x = 0, drift_y = 0;  // [m/s, field] over 0.5 s before and after: more exact for a robot that stands
  double drift_deviation = 0;       // [m/s]
  bool fallen = false;
};

/// One change of the ball's velocity: a rebound, a push or a kick.
struct Touch {
  std::size_t recording = 0;          // index of the truth
  double at = 0;                      // [s] since the epoch of the truth
  double x = 0, y = 0;                // [m, field] the ball
  double deviation = 0;               // [m] of that place
  double before_x = 0, before_y = 0;  // [m/s, field] velocity just before
  double after_x = 0, after_y = 0;    // [m/s, field] just after
  double before_deviation = 0;        // [m/s]
  double after_deviation = 0;         // [m/s]
  double lateness = 0;                // [s] deviation of the moment
  std::vector<Toucher> near;          // robots within 0.5 m, the nearest first
};

/// The touches of a game, and those that are not clear.
struct TouchesSeen {
  std::vector<Touch> touches;
  std::size_t unclear = 0;   // the ball's way before and after is not that of two free rolls
  std::size_t left_out = 0;  // places of the ball that are impossible
};

/// Finds the touches. The velocity changes by at least 0.2 m/s and four of its deviations. Time, place and velocities of a
/// touch are those of the best two rolls that meet there. Both slow down by `deceleration` [m/s²].
TouchesSeen touches_in(const lab::TruthRecord& truth, double deceleration, std::size_t recording);

}  // namespace robot::fit
