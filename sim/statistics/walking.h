// How robots walk and fall.
#pragma once

#include "sim/statistics/window.h"

namespace sim::statistics {

/// Speeds of robots, and time on the ground. A robot that is seen in fewer than 50 frames does not count.
struct Walking {
  double standing;           // share of robots slower than 0.05 m/s
  double speed_median;       // [m/s] of robots that do not stand
  double speed_99;           // [m/s] 99 % of all robots are slower
  double metres_per_minute;  // [m/min] walked by a robot
  double falls_per_minute;   // [1/min] falls of a robot
  double down;               // share of robots on the ground
};

/// Measures all robots. The speed of a robot is the displacement over 1 s of its place averaged over 11 frames; above
/// 0.8 m/s it is an error and left out. A robot counts as on the ground where it is down in 22 of 30 frames.
Walking walking_of(const Window& window);

}  // namespace sim::statistics
