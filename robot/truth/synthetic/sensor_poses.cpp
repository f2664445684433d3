#include "robot/truth/synthetic/sensor_poses.h"

namespace robot::truth {

SensorPose looking(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const Intrinsics& intrinsics) {
  const Eigen::Vector3d forward = (target - eye).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  SensorPose pose{.intrinsics = intrinsics};
  pose.field_from_sensor.linear() << right, forward.cross(right), forward;
  pose.field_from_sensor.translation() = eye;
  return pose;
}

SensorPose mast(const sim::field::Field& field, double side, double x, const Intrinsics& intrinsics) {
  const double behind_touch_line = 1.2, height = 2.1, reach = 3.4;  // [m]
  const double distance = static_cast<double>(field.width) / 2 + behind_touch_line;
  return looking({x, side * distance, height}, {x, side * (distance - reach), 0}, intrinsics);
}

}  // namespace robot::truth
