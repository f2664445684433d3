// The errors of a robot's believed pose beside the truth, and the events that made them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/localisation/watched_motion.h"

namespace robot::fit {

/// The error of the pose at one moment.
struct PoseError {
  double at = 0;  // [s, clock of the truth]
  double x = 0, y = 0,
         heading = 0;  // [m, rad; team_field] believed minus true; of a flipped pose: minus the flipped truth
  double true_x = 0, true_y = 0;   // [m, team_field]
  double deviation = NAN;          // [m] as the robot reported it; NaN: not
  double deviation_heading = NAN;  // [rad]
  double noise = 1;                // share of the truth's variance in the error
  double since = 0;                // [s] since the last fall or entrance; since the begin of the recording before any
  bool upright = true, walks = false, flipped = false;
  bool entered = false, fell = false;  // since the error before
  double sign = 1;                     // -1: the team's frame is the field turned by half a circle

  double far() const { return std::hypot(x, y); }
  /// Reports whether the robot is unsure of its pose, as a simulated one must be to flip. Without deviations it always may be.
  bool is_unsure() const;
};

/// A change of the error by one event, or the first error after it.
struct PoseShift {
  std::size_t recording = 0;
  double at = 0;                     // [s, clock of the truth]
  double x = 0, y = 0, heading = 0;  // [m, rad; team_field]
  double events = 1;                 // falls in it: an attempt to get up that fails is another one
  double place_noise = 0;            // [m²] variance of the truth in it, each axis
  double heading_noise = 0;          // [rad²]
};

/// A time in which the pose was turned round by half a circle.
struct PoseFlip {
  std::size_t recording = 0;
  double at = 0, duration = 0;  // [s]
  bool seen_begin = false;      // false: it was turned round from the first moment
  bool seen_end = false;        // false: the robot was taken away before, or the recording ended
};

/// One standard deviation of the truth, of each coordinate.
struct TruthNoise {
  double place = 0, heading = 0;  // [m], [rad]
};

struct PoseErrors {
  std::vector<std::string> recordings;         // names, by index
  std::vector<std::vector<PoseError>> errors;  // by recording, in the order of the times
  std::vector<TruthNoise> noises;              // of the truth, by recording
  std::vector<PoseShift> starts, falls;
  std::vector<PoseFlip> flips;
  double unsure_seconds = 0;   // of upright robots that may flip
  double watched_seconds = 0;  // of all poses beside the truth
  double place_noise = 0;      // [m] one standard deviation of the truth, each axis, by robots that stand
  double heading_noise = 0;    // [rad] likewise
  std::size_t falls_left_out = 0, damaged = 0;
  std::size_t without_sides = 0;  // recordings whose direction of play comes from the poses themselves
};

/// Adds the errors and events of a robot. The direction of play is that of `game`; without it the recording is turned as it fits
/// best, with one change of sides at most. An entrance is the end of a penalty, the begin of a half, and the begin of a recording
/// before play. A fall's shift is the error just before the robot stands again minus the error just before it fell.
void add_pose_errors(const WatchedMotion& motion, PoseErrors& all);

/// Returns the noise of the truth by a robot that stands, 0 and 0 if it does not.
TruthNoise truth_noise(const WatchedMotion& motion);

}  // namespace robot::fit
