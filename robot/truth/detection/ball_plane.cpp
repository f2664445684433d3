#include "robot/truth/detection/ball_plane.h"

namespace robot::truth {

using Eigen::Vector2d;
using Eigen::Vector3d;

BallPlane::BallPlane(const SensorPose& pose, double radius)
    : pose_(pose), radius_(radius), up_(pose.field_from_sensor.linear().row(2)) {}

std::optional<Vector3d> BallPlane::centre(const Vector2d& pixel) const {
  const Vector3d ray = pose_.ray(pixel.x(), pixel.y());
  const double fall = -ray.dot(up_);
  if (fall <= 1e-3) return std::nullopt;
  return ray * ((pose_.field_from_sensor.translation().z() - radius_) / fall);
}

bool BallPlane::whole(const Vector2d& pixel, double radius_px) const {
  return pixel.minCoeff() >= radius_px && pixel.x() + radius_px <= pose_.intrinsics.width &&
         pixel.y() + radius_px <= pose_.intrinsics.height;
}

Place BallPlane::place(const Vector2d& pixel, double deviation_px) const {
  const auto ground = [&](const Vector2d& at) { return on_ground(centre(at).value_or(Vector3d::Zero())); };
  // towards the bottom of the image, so that no pixel is above the horizon
  const double step = 0.5;
  Place place{.position = ground(pixel)};
  Eigen::Matrix2d slope;
  slope << ground(pixel + Vector2d(step, 0)) - place.position, ground(pixel + Vector2d(0, step)) - place.position;
  place.covariance = deviation_px * deviation_px / (step * step) * slope * slope.transpose();
  return place;
}

}  // namespace robot::truth
