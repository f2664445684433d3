// The costs of the assignment of detections to robots: negative logarithms of densities and probabilities.
#pragma once

#include "robot/truth/tracks/own_poses.h"
#include "robot/truth/tracks/scene.h"

namespace robot::truth {

constexpr double kMissCost = 2.3;    // a robot in view is overlooked in one image of ten
constexpr double kImpossible = 1e6;  // more than all other costs together

/// Returns the cost of a place that was seen where a robot is expected, or kImpossible.
double place_cost(const Place& expected, const Place& seen);

/// Returns the cost that tag and own pose add if the robot is the seen one; kImpossible if the tag is another player's.
double identity_cost(const TrackScene& scene, const RobotTrack& robot, const SeenRobot& seen, const OwnPoses& poses);

/// Returns the index of the player whose tag was read, or nothing.
std::optional<std::size_t> tagged_player(const SeenRobot& seen, const OwnPoses& poses);

/// Reports whether a confirmed robot was not seen for more than 0.1 s, and in the two images before this one.
bool hidden(const TrackScene& scene, const RobotTrack& robot);

}  // namespace robot::truth
