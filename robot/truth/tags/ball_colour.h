// The ball in a picture, by its colour and its size.
#pragma once

#include <optional>

#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/frame/detections.h"
#include "robot/truth/tags/camera.h"
#include "robot/truth/tags/spots.h"

namespace robot::truth::tags {

/// The size and the colour of the ball.
struct BallLook {
  double radius = 0.0325;  // [m]
  ColourRange colours;
};

/// Returns the ball on the carpet, or nothing. A spot of that colour is a ball if it is as large and as round as the ball at
/// this place is. The centre is the ray of the spot's middle in the plane at the height of the radius. A ball that
/// is partly hidden has a greater covariance; one of which less than 40 % is visible is not reported.
std::optional<SeenBall> find_ball(const DepthFrame& picture, const Camera& camera, const BallLook& look);

}  // namespace robot::truth::tags
