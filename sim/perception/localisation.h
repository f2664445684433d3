// A robot's believed pose: odometry drifts, marks correct it, and sometimes the pose flips to the other half.
//
// The believed deviations are consistent: the squared error divided by the variance is 1 on average, without flips.
#pragma once

#include <cmath>
#include <span>

#include "sim/perception/look.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// Returns the robot's true pose. [team_field]
Pose2 true_pose(const World& world, int robot);

/// Corrects the believed poses after `predict`. A robot that fell loses its pose. A robot looks at the marks in the first
/// image of each `mark_interval` of game time. At most kMostLooks at once.
void localise(const PerceptionParams& params, std::span<const Look> looks);

/// Looks at the marks, for each robot after `steps` ticks without a look, at least the model's `mark_interval`. One draw
/// settles the effect of odometry and marks on the belief in that time. Then the pose may flip, or the robot may notice
/// its flip.
void look_round(const PerceptionParams& params, std::span<const Look> looks);

/// Shifts and turns the belief of a robot that fell since its last perception, and makes it that much less sure. The
/// robot notices the fall. An attempt to get up that fails counts as another fall. Draws lost_pose (number: tick).
void lose_pose(const Localisation& model, const World& world, int robot, agent::Pose& belief);

/// Reports whether the body fell in the `steps` ticks before `now`.
inline bool fell(const Body& body, Tick now, Tick steps) {
  return body.doing == Body::Doing::fallen && body.since < now && body.since + steps >= now;
}

}  // namespace sim::perception
