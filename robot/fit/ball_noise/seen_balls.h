// The ball as a robot's recording has it: percepts, beliefs, and the body meanwhile.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "robot/fit/evidence.h"

namespace robot::fit {

/// The body while an image was taken.
enum class Gait {
  unknown,  // the motion did not report it
  standing,
  moving,  // upright, but not standing: it walks, starts, stops or kicks
  down,    // falls, lies or gets up
};

/// A percept or a belief.
struct SeenBall {
  std::uint64_t capture_ns = 0;      // [ns since the epoch, clock of the robot] of the image
  double distance = 0, bearing = 0;  // [m], [rad, robot]
};

/// A report of the motion.
struct GaitReport {
  std::uint64_t capture_ns = 0;  // [ns since the epoch, clock of the robot]
  Gait gait = Gait::unknown;
};

/// The recording of one robot.
struct SeenBalls {
  const WatchedRobot* robot = nullptr;  // not owned
  std::vector<SeenBall> percepts;       // from `vision`
  std::vector<SeenBall> beliefs;        // from `ball`, those of images that show it
  std::vector<GaitReport> gaits;        // from `motion_status`
  std::optional<double> writing;  // [s] median time from the capture to the writing of a belief, else of a percept
};

/// Reads each of the three streams once.
SeenBalls read_seen_balls(const WatchedRobot& robot);

/// Returns the median time from capture to publication [s] if it says anything. A writer that repeats the capture
/// time says nothing, nor does a median of a second or more, nor fewer than 20 messages.
std::optional<double> writing_time(std::vector<double> delays);

}  // namespace robot::fit
