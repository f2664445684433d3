// The error of a sensor's pose, at a place on the field.
#pragma once

#include <array>
#include <vector>

#include "robot/truth/tracks/sensor.h"

namespace robot::truth {

/// Returns the covariance [m²] of the horizontal error that the error of the sensor's pose causes at a point [m, field].
/// All measurements of the sensor near this point share the error: it does not average away.
Eigen::Matrix2d shared_covariance(const SensorPose& pose, const Eigen::Vector3d& point, Ranging ranging);

/// The shared covariance of each sensor at one place [m²]; zero for sensors that do not exist.
using SharedErrors = std::array<Eigen::Matrix2d, kMostSensors>;

inline SharedErrors no_errors() {
  SharedErrors none;
  none.fill(Eigen::Matrix2d::Zero());
  return none;
}

/// Return those of a robot and of a ball at a place [m, field].
SharedErrors robot_errors(const std::vector<Sensor>& sensors, const Eigen::Vector2d& place);
SharedErrors ball_errors(const std::vector<Sensor>& sensors, const Eigen::Vector2d& place);

}  // namespace robot::truth
