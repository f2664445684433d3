// The motion of robots and ball between two images.
#pragma once

#include "robot/truth/tracks/estimate.h"

namespace robot::truth {

/// Deviation of a robot's velocity along an axis [m/s], when nothing else is known. A Nao walks up to about 0.4 m/s.
constexpr double kRobotSpeed = 0.3;
/// Time [s] after which a robot has forgotten most of its velocity. Together with kRobotSpeed: within half a second a
/// velocity changes by 0.2 m/s (one deviation), and a robot that hides for 2 s is within 0.35 m of the straight line.
constexpr double kRobotMemory = 2;

/// Deceleration of a rolling ball [m/s²]: friction 0.0275 on carpet (Mellmann 2016). Noise covers other carpets.
constexpr double kBallFriction = 0.27;
/// Deviation of the change of a ball's velocity along an axis by a kick or a rebound [m/s].
constexpr double kKickSpeed = 1.5;

/// Returns the motion of a robot over `dt` [s]: its velocity forgets itself slowly (Ornstein, Uhlenbeck).
/// Exact: two half steps are one whole step, except for offsets whose `shared` changes.
Step robot_step(const SharedErrors& shared, double dt);

/// Returns the motion of a ball that rolls and is slowed down for `dt` [s], close to the mean of the estimate.
Step ball_step(const Estimate& ball, const SharedErrors& shared, double dt);

/// Adds a sudden change of the velocity at an unknown moment of the `dt` [s] of the step.
void add_kick(Step& step, double dt);

}  // namespace robot::truth
