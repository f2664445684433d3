// Cameras that look at the field, and poses of tags.
#pragma once

#include <Eigen/Geometry>
#include <numbers>

#include "robot/truth/tags/camera.h"
#include "robot/truth/tags/picture.h"

namespace tests {

inline constexpr double kDegree = std::numbers::pi / 180;  // [rad]

/// Returns a camera of this size whose optical axis points to `target` on the carpet. Its picture's upper edge is away from
/// it; straight above the target it points to +y.
robot::truth::tags::Camera camera_above(const Eigen::Vector3d& from, const Eigen::Vector2d& target,
                                        robot::truth::tags::PictureSize size, double focal);

/// Returns the pose of a flat tag: the upper edge points to `turn` [rad]. Frame `tag` as in robot/truth/tags/tag_pose.h.
Eigen::Isometry3d flat_tag(const Eigen::Vector3d& centre, double turn);

}  // namespace tests
