#include "robot/truth/tags/camera.h"

#include <cmath>

namespace robot::truth::tags {

std::optional<Eigen::Vector2d> Camera::on_plane(const Eigen::Vector2d& pixel, double height) const {
  constexpr double kFlattest = 1e-3;  // sine of the flattest ray that hits the plane at a useful place
  const auto ray = projection.ray(pixel);
  if (!ray) return std::nullopt;
  const Eigen::Vector3d from = field_from_camera.translation(), way = field_from_camera.linear() * ray->normalized();
  if (std::abs(way.z()) < kFlattest) return std::nullopt;
  const double distance = (height - from.z()) / way.z();
  if (distance <= 0) return std::nullopt;
  return (from + distance * way).head<2>();
}

std::optional<Eigen::Vector2d> Camera::pixel(const Eigen::Vector3d& point_in_field) const {
  constexpr double kNearest = 1e-3;  // [m]
  const Eigen::Vector3d seen = field_from_camera.inverse() * point_in_field;
  if (seen.z() < kNearest) return std::nullopt;
  return projection.pixel(seen);
}

}  // namespace robot::truth::tags
