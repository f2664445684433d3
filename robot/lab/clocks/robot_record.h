// The beliefs of a recorded robot that ground truth can judge: the ball and its own pose.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/lab/clocks/series.h"
#include "robot/lab/clocks/start_gesture.h"
#include "robot/logging/sessions/session.h"

namespace robot::lab {

/// The belief about the ball at an image that shows it.
struct BallBelief {
  double at = 0;        // [s] since the record's epoch
  double x = 0, y = 0;  // [m, robot]
};

/// The belief about the own pose.
struct PoseBelief {
  double at = 0;                     // [s] since the record's epoch
  double x = 0, y = 0, heading = 0;  // [m, rad; team_field]
};

struct RobotRecord {
  std::string name;                 // "14/2"
  std::vector<BallBelief> balls;    // in the order of the times
  std::vector<PoseBelief> poses;    // likewise
  std::vector<Sighting> sightings;  // of the ball: by the images, or else by the belief
  Series ranges;                    // [m] distance of the ball in images, or else of the belief; tidied

  bool empty() const { return balls.empty() && poses.empty() && ranges.empty(); }
};

/// Returns the beliefs of the session's robot. Times are seconds since `epoch_ns`. Images are preferred for the range,
/// because a belief is late by the delay of its filter. Leaves out damaged messages and values that are not finite.
RobotRecord read_robot(const logging::Session& session, std::uint64_t epoch_ns);

}  // namespace robot::lab
