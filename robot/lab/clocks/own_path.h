// The path of a recorded robot among the robots of the ground truth.
#pragma once

#include <string>

#include "robot/core/result.h"
#include "robot/lab/clocks/lag_search.h"
#include "robot/lab/clocks/pose_fit.h"
#include "robot/lab/clocks/robot_record.h"
#include "robot/lab/clocks/truth_record.h"

namespace robot::lab {

/// The robot of the truth that is ours.
struct OwnPath {
  std::string name;  // of TrueRobotPath
  std::string by;    // "its number", "its pose", "the best fit", "the only robot"
  Path path;         // by its pose: also where the truth lost the robot and gave it another name
  FieldPoses poses;  // empty if the robot recorded no pose, or if its poses fit no path
};

/// Finds the robot's own path: by its number if the truth has it, else by its pose if that is clearly closest to one path.
/// Otherwise the distances to the ball must fit one path clearly best. Returns an Error with the reason if none is found.
Result<OwnPath> own_path(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range);

/// Returns the distance between the robot and the ball, as truth and robot have it.
SharedDistance ball_distance(const TruthRecord& truth, const Path& own, const RobotRecord& robot);

}  // namespace robot::lab
