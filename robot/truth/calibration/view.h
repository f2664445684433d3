// A sensor's pose, depth scale and camera, as the parameters of a fit.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "robot/truth/frame/projection.h"
#include "robot/truth/frame/sensor_pose.h"

namespace robot::truth {

/// The number of parameters of a View: the seven of SensorPose::covariance in their order, then the logarithm of the focal
/// length and the lens's k1.
inline constexpr int kViewParameters = 9;
using ViewStep = Eigen::Matrix<double, kViewParameters, 1>;
using ViewCovariance = Eigen::Matrix<double, kViewParameters, kViewParameters>;

struct View {
  Eigen::Isometry3d field_from_sensor = Eigen::Isometry3d::Identity();
  double depth_scale = 1;  // true depth / measured depth
  Projection camera;

  /// Returns the view after a small step of its parameters.
  View moved(const ViewStep& step) const;

  /// Returns a point [m, field] in the frame `sensor`.
  Eigen::Vector3d seen(const Eigen::Vector3d& point) const { return field_from_sensor.inverse() * point; }
  /// Returns the point [m, field] at a pixel and its measured depth [m], or nothing where the lens shows nothing.
  std::optional<Eigen::Vector3d> point(const Eigen::Vector2d& pixel, double measured_depth) const;
  /// Returns the point [m, field] at a pixel whose height above the carpet is known [m]. Returns nothing above the horizon.
  std::optional<Eigen::Vector3d> point_at_height(const Eigen::Vector2d& pixel, double height) const;

  SensorPose pose(const ViewCovariance& covariance) const;
};

}  // namespace robot::truth
