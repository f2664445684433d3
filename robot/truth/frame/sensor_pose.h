// The place of a sensor beside the field, as its calibration found it.
#pragma once

#include <Eigen/Geometry>

#include "robot/truth/frame/depth_frame.h"

namespace robot::truth {

/// The pose of a sensor and the scale of its depths, with their errors. Frame `field`: origin at the centre, +x towards the
/// goal that the home team attacks in the first half, +y left of it, +z up, the carpet at z = 0.
struct SensorPose {
  Intrinsics intrinsics;
  Eigen::Isometry3d field_from_sensor = Eigen::Isometry3d::Identity();
  double depth_scale = 1;  // true depth / measured depth

  /// Covariance of the error: a rotation [rad] about the sensor's axes applied before field_from_sensor, a translation [m]
  /// in `field`, and the depth scale. Zero: exact.
  Eigen::Matrix<double, 7, 7> covariance = Eigen::Matrix<double, 7, 7>::Zero();

  /// Returns the direction of a pixel's ray in the frame `sensor`, with z = 1.
  Eigen::Vector3d ray(double pixel_x, double pixel_y) const {
    return {(pixel_x - intrinsics.centre_x) / intrinsics.focal_x, (pixel_y - intrinsics.centre_y) / intrinsics.focal_y,
            1};
  }
  /// Returns the point [m, field] that a pixel shows, at the measured depth [m].
  Eigen::Vector3d point(double pixel_x, double pixel_y, double measured_depth) const {
    return field_from_sensor * (ray(pixel_x, pixel_y) * measured_depth * depth_scale);
  }
  /// Returns the pixel of a point [m, field]. The point is in front of the sensor.
  Eigen::Vector2d pixel(const Eigen::Vector3d& point_in_field) const {
    const Eigen::Vector3d seen = field_from_sensor.inverse() * point_in_field;
    return {intrinsics.centre_x + intrinsics.focal_x * seen.x() / seen.z(),
            intrinsics.centre_y + intrinsics.focal_y * seen.y() / seen.z()};
  }
};

}  // namespace robot::truth
