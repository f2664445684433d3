// The drift of a robot's odometry: its believed way beside the true one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/localisation/watched_motion.h"

namespace robot::fit {

/// A part of a walk: its error beside the truth. The believed steps are turned to the true headings first, so the drift of the
/// heading does not count as one of the place.
struct DriftWindow {
  std::size_t recording = 0;
  double at = 0;                           // [s] of its begin, since the epoch of the truth
  double duration = 0;                     // [s]
  double way = 0, turned = 0;              // [m], [rad] walked and turned, by the robot's speeds
  double grown_way = 0, grown_turned = 0;  // likewise, less than these by the means over both ends
  double true_x = 0, true_y = 0;           // [m, field] true displacement
  double true_turn = 0;                    // [rad]
  double error_x = 0, error_y = 0;         // [m, field] believed displacement minus the true one
  double error_turn = 0;                   // [rad]
};

/// Counts of the moments that are no part of a window.
struct DriftLosses {
  std::size_t lying = 0, crowded = 0, carried = 0, unseen = 0, damaged = 0;  // odometry messages
};

/// The lengths of windows: way, and half a metre for each radian turned [m].
inline constexpr double kDriftLengths[] = {0.5, 1, 2};
/// The lengths of the windows for a look at the growth [m].
inline constexpr double kGrowthLengths[] = {0.25, 0.5, 1, 2, 4, 8};

struct Drift {
  std::vector<std::string> recordings;  // names, by index
  std::vector<DriftWindow> windows;     // of kDriftLengths in turn
  std::vector<DriftWindow> growth;      // of each of kGrowthLengths; they overlap with one another
  DriftLosses losses;
};

/// Cuts the walk of a robot into windows and adds them. A robot that stands gives windows of two seconds, which show the error of
/// the truth. A window ends where the robot lies, is penalised or carried, and where another robot is within 0.6 m. It also ends
/// where truth or odometry have a gap or jump. Both ends are means over a third of a second.
void add_drift(const WatchedMotion& motion, Drift& drift);

}  // namespace robot::fit
