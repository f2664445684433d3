#include "robot/truth/calibration/view.h"

#include <cmath>

namespace robot::truth {

View View::moved(const ViewStep& step) const {
  View view = *this;
  const Eigen::Vector3d turn = step.head<3>();
  if (const double angle = turn.norm(); angle > 0)
    view.field_from_sensor.linear() *= Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  view.field_from_sensor.translation() += step.segment<3>(3);
  view.depth_scale += step[6];
  view.camera.intrinsics.focal_x *= std::exp(step[7]);
  view.camera.intrinsics.focal_y *= std::exp(step[7]);
  view.camera.lens.k1 += step[8];
  return view;
}

std::optional<Eigen::Vector3d> View::point(const Eigen::Vector2d& pixel, double measured_depth) const {
  const auto ray = camera.ray(pixel);
  if (!ray) return std::nullopt;
  return field_from_sensor * (*ray * measured_depth * depth_scale);
}

std::optional<Eigen::Vector3d> View::point_at_height(const Eigen::Vector2d& pixel, double height) const {
  const auto ray = camera.ray(pixel);
  if (!ray) return std::nullopt;
  const Eigen::Vector3d direction = field_from_sensor.linear() * *ray, eye = field_from_sensor.translation();
  const double depth = (height - eye.z()) / direction.z();
  if (!(depth > 0) || !std::isfinite(depth)) return std::nullopt;
  return eye + depth * direction;
}

SensorPose View::pose(const ViewCovariance& covariance) const {
  return {.intrinsics = camera.intrinsics,
          .field_from_sensor = field_from_sensor,
          .depth_scale = depth_scale,
          .covariance = covariance.topLeftCorner<7, 7>()};
}

}  // namespace robot::truth
