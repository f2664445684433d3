// The pose of a printed tag from its four corners.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/truth/tags/camera.h"
#include "robot/truth/tags/seen_tag.h"

namespace robot::truth::tags {

/// One standard deviation of a corner in the picture [px], along x and along y. Rendered pictures show 0.1. A
/// real camera adds the errors of its lens model and its rolling shutter.
inline constexpr double kCornerDeviation = 0.2;

/// The white margin shines over the black square: blur and a camera's gamma move each side inwards by this [px]. The
/// amount depends on focus and light; its deviation is that of rendered pictures.
inline constexpr double kShine = 0.25, kShineDeviation = 0.15;

/// Returns the corners of a tag in the picture, or nothing if one is behind the camera. Frame `tag` as in TagPose.
std::optional<Corners> corners_in_picture(const Camera& camera, const Eigen::Isometry3d& field_from_tag, double edge,
                                          double shine = kShine);

/// A pose that explains the corners. Frame `tag`: origin at the middle of the print, +x to its right edge, +y to its upper
/// edge, +z towards the reader.
struct TagPose {
  Eigen::Isometry3d field_from_tag = Eigen::Isometry3d::Identity();

  /// Covariance of the centre [m, field] and of a rotation [rad] about the field's axes.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();

  /// The sum of all squared errors, each in standard deviations: of the corners, and of a standing robot's sway. About 5 if
  /// the pose is right.
  double cost = 0;

  double height() const { return field_from_tag.translation().z(); }             // [m]
  Eigen::Vector3d normal() const { return field_from_tag.linear().col(2); }      // [field]
  Eigen::Vector3d upper_edge() const { return field_from_tag.linear().col(1); }  // [field] from the centre to it
  double tilt() const { return std::acos(std::min(1.0, normal().z())); }         // [rad] 0: it looks up
};

/// Returns the pose of a tag that lies flat at `height` [m], as on a standing robot. The robot sways: the height has a
/// deviation of 1 cm, the tilt one of 5°. The corners correct both where they show it. This is much
/// better than a pose without such knowledge. Returns nothing if no such pose is in view.
std::optional<TagPose> standing_pose(const Camera& camera, const Corners& corners, double edge, double height);

/// Returns the pose of a tag of which only the edge [m] is known, at any place and turned in any way. Of the two poses that
/// a small square allows, it is the one that explains the corners better. Returns nothing without such a pose.
std::optional<TagPose> free_pose(const Camera& camera, const Corners& corners, double edge);

}  // namespace robot::truth::tags
