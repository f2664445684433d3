// Cameras that look at the field, and poses of tags.
#pragma once

#include <Eigen/Geometry>
#include <numbers>

#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/tags/camera.h"

namespace tests {

inline constexpr double kDegree = std::numbers::pi / 180;  // [rad]

struct PictureSize {
  int width = 0, height = 0;  // [px]
};

/// Returns a black picture of an ordinary camera.
robot::truth::DepthFrame black_picture(PictureSize size);

/// Returns a camera of this size whose optical axis points to `target` on the carpet. Its picture's upper edge is away from
/// it; straight above the target it points to +y.
robot::truth::tags::Camera camera_above(const Eigen::Vector3d& from, const Eigen::Vector2d& target, PictureSize size,
                                        double focal);

/// Returns the pose of a flat tag: the upper edge points to `turn` [rad]. Frame `tag` as in robot/truth/tags/tag_pose.h.
Eigen::Isometry3d flat_tag(const Eigen::Vector3d& centre, double turn);

}  // namespace tests
