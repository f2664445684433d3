// The ball filter: from percepts to a believed ball.
//
// It is a Kalman filter of position and velocity in the robot's frame. Both axes are independent and share one
// covariance. It uses believed odometry, so a robot that misjudges its walk also misjudges the ball.
#pragma once

#include <span>

#include "sim/agent/beliefs.h"
#include "sim/perception/ball_sight.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// Returns the belief about a ball that was never seen: it may be anywhere.
agent::Ball unknown_ball(const BallFilter& filter);

inline constexpr float kForgotten = 0.5f;  // [s] unseen; after that the ball may appear anywhere

/// Updates the believed balls with the images up to now and with their percepts[i], if there are any.
///
/// A percept farther off than `reacquire` standard deviations restarts the filter if the ball was forgotten or if several
/// images show it. Otherwise the percept is doubted: the belief keeps its place, but becomes so uncertain that it accepts
/// the next percept there. Each image without the ball reduces the heat by a tenth.
void update(const PerceptionParams& params, std::span<const Look> looks, std::span<const BallPercept> percepts);

}  // namespace sim::perception
