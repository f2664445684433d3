// Images of sensors for the tests of the tracks.
#pragma once

#include <cmath>
#include <vector>

#include "robot/truth/tracks/fused_truth.h"
#include "robot/truth/tracks/sensor.h"

namespace robot::truth {

constexpr std::uint64_t kBegin = 1'700'000'000'000'000'000;  // [ns]

inline std::uint64_t at_seconds(double seconds) {
  return kBegin + static_cast<std::uint64_t>(std::llround(seconds * 1e9));
}

inline Place seen_at(double x, double y, double deviation = 0.02) {
  return {{x, y}, deviation * deviation * Eigen::Matrix2d::Identity()};
}

/// Returns an image that shows standing robots at these places.
inline SensorImage image_of(double seconds, const std::vector<Eigen::Vector2d>& robots, std::size_t sensor = 0) {
  SensorImage image{.sensor = sensor, .detections = {}};
  image.detections.capture_ns = at_seconds(seconds);
  image.detections.detected_ns = image.detections.capture_ns + 2'000'000;
  for (const Eigen::Vector2d& robot : robots) {
    image.detections.robots.emplace_back();
    image.detections.robots.back().place = seen_at(robot.x(), robot.y());
    image.detections.robots.back().height = 0.57;
  }
  return image;
}

inline SensorImage with_ball(SensorImage image, const Eigen::Vector2d& ball) {
  image.detections.ball = SeenBall{seen_at(ball.x(), ball.y(), 0.01)};
  return image;
}

/// Returns a sensor 3 m beside the field on a mast of 2 m, that looks at the field's centre, with these errors of its pose.
inline Sensor sensor_beside(double translation_deviation, double rotation_deviation = 0) {
  Sensor sensor;
  const Eigen::Vector3d forward = Eigen::Vector3d(0, 3, -2).normalized();
  const Eigen::Vector3d right(1, 0, 0);
  sensor.pose.field_from_sensor.linear() << right, forward.cross(right), forward;
  sensor.pose.field_from_sensor.translation() << 0, -3, 2;
  sensor.pose.covariance.diagonal().head<3>().setConstant(rotation_deviation * rotation_deviation);
  sensor.pose.covariance.diagonal().segment<3>(3).setConstant(translation_deviation * translation_deviation);
  return sensor;
}

}  // namespace robot::truth
