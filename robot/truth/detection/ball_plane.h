// The places of a ball that lies on the carpet.
#pragma once

#include <optional>

#include "robot/truth/frame/detections.h"
#include "robot/truth/frame/sensor_pose.h"

namespace robot::truth {

/// The plane in which the centre of a ball moves, as one sensor sees it. A bearing gives the place: the range by the plane is
/// ten times more exact than a measured depth.
class BallPlane {
 public:
  BallPlane(const SensorPose& pose, double radius);

  double radius() const { return radius_; }  // [m] of the ball

  /// Returns the centre [m, sensor] of a ball that is seen at a pixel, or nothing for a pixel above the horizon.
  std::optional<Eigen::Vector3d> centre(const Eigen::Vector2d& pixel) const;

  /// Returns the radius [px] of the image of a ball [m, sensor].
  double radius_px(const Eigen::Vector3d& centre) const { return pose_.intrinsics.focal_x * radius_ / centre.z(); }

  /// Reports whether all of a ball's image is within the image.
  bool whole(const Eigen::Vector2d& pixel, double radius_px) const;

  /// Returns the place of a ball [m, sensor] on the ground.
  Eigen::Vector2d on_ground(const Eigen::Vector3d& centre) const {
    return (pose_.field_from_sensor * centre).head<2>();
  }

  /// Returns the place of a ball at a pixel below the horizon, whose error is `deviation_px` in each direction.
  Place place(const Eigen::Vector2d& pixel, double deviation_px) const;

 private:
  SensorPose pose_;
  double radius_;
  Eigen::Vector3d up_;  // [sensor]
};

}  // namespace robot::truth
