// The poses that a robot believed, compared with one path of the ground truth.
#pragma once

#include <vector>

#include "robot/lab/clocks/lag_search.h"
#include "robot/lab/clocks/robot_record.h"
#include "robot/lab/clocks/truth_record.h"

namespace robot::lab {

/// The poses that a robot believed, turned to the frame of the ground truth. A team's frame is turned by half a circle
/// while the team attacks the other goal, which changes between the halves of a game.
struct FieldPoses {
  std::vector<PoseBelief> poses;  // [field] in the order of their times
  double error = 1;               // [m] mean distance to the path, each at most 1 m
  double lag = 0;                 // [s] of the robot's clock, to half a second

  bool empty() const { return poses.empty(); }
};

/// Turns the poses so that they are closest to the path, in stretches of half a minute, and finds the lag of the closest fit.
/// Returns no poses if fewer than fifteen of them, one a second, have a place.
FieldPoses fit_poses(const std::vector<PoseBelief>& poses, const Path& path, const LagRange& range);

/// Returns the pose that was believed last at a moment [s], or null if it is older than a tenth of a second.
const PoseBelief* pose_at(const std::vector<PoseBelief>& poses, double at);

}  // namespace robot::lab
