// A calibrated ordinary camera beside or above the field.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "robot/truth/frame/projection.h"

namespace robot::truth::tags {

/// A camera's projection and its place. Frame `field` as in robot/truth/frame/sensor_pose.h; pixels as in depth_frame.h.
struct Camera {
  Projection projection;
  Eigen::Isometry3d field_from_camera = Eigen::Isometry3d::Identity();

  /// Returns the point that a pixel shows if it is `height` [m] above the carpet, or nothing if the ray does not go there.
  std::optional<Eigen::Vector2d> on_plane(const Eigen::Vector2d& pixel, double height) const;

  /// Returns the pixel of a point [m, field], or nothing if it is behind the camera. It may be outside the picture.
  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& point_in_field) const;
};

}  // namespace robot::truth::tags
