#include "robot/truth/tracks/shared_error.h"

#include <algorithm>
#include <cmath>

namespace robot::truth {
namespace {

using Jacobian = Eigen::Matrix<double, 3, 7>;

constexpr double kLeastFall = 0.02;   // of a ray per metre: flatter rays count as this flat
constexpr double kRobotHeight = 0.3;  // [m] of the points from which a robot's place is computed
constexpr double kBallHeight = 0.05;  // [m] of the plane in which a ball is placed

/// Returns the motion of a point that is fixed in the sensor's frame, by rotation, translation and depth scale.
Jacobian motion_of_point(const SensorPose& pose, const Eigen::Vector3d& seen) {
  const Eigen::Matrix3d rotation = pose.field_from_sensor.linear();
  Eigen::Matrix3d crossed;  // crossed * r = seen x r
  crossed << 0, -seen.z(), seen.y(), seen.z(), 0, -seen.x(), -seen.y(), seen.x(), 0;

  Jacobian jacobian;
  jacobian << -rotation * crossed, Eigen::Matrix3d::Identity(), rotation * seen / pose.depth_scale;
  return jacobian;
}

SharedErrors errors_at(const std::vector<Sensor>& sensors, const Eigen::Vector3d& point, Ranging Sensor::*ranging) {
  SharedErrors shared = no_errors();
  for (std::size_t i = 0; i < sensors.size(); ++i)
    shared[i] = shared_covariance(sensors[i].pose, point, sensors[i].*ranging);
  return shared;
}

}  // namespace

Eigen::Matrix2d shared_covariance(const SensorPose& pose, const Eigen::Vector3d& point, Ranging ranging) {
  const Eigen::Vector3d ray = point - pose.field_from_sensor.translation();
  Jacobian jacobian = motion_of_point(pose, pose.field_from_sensor.linear().transpose() * ray);

  // the place slides along the ray until it is at its known height again
  if (ranging == Ranging::plane) {
    const double fall = std::copysign(std::max(std::abs(ray.z()), kLeastFall * ray.norm()), ray.z());
    jacobian -= ray / fall * jacobian.row(2).eval();
  }
  const Eigen::Matrix<double, 2, 7> horizontal = jacobian.topRows<2>();
  return horizontal * pose.covariance * horizontal.transpose();
}

SharedErrors robot_errors(const std::vector<Sensor>& sensors, const Eigen::Vector2d& place) {
  return errors_at(sensors, {place.x(), place.y(), kRobotHeight}, &Sensor::robots);
}

SharedErrors ball_errors(const std::vector<Sensor>& sensors, const Eigen::Vector2d& place) {
  return errors_at(sensors, {place.x(), place.y(), kBallHeight}, &Sensor::ball);
}

}  // namespace robot::truth
