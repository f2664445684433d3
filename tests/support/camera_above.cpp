#include "tests/support/camera_above.h"

namespace tests {

using robot::truth::tags::Camera;

robot::truth::DepthFrame black_picture(PictureSize size) {
  robot::truth::DepthFrame picture{.intrinsics = {.width = size.width, .height = size.height, .baseline = 0}};
  picture.rgb.resize(3 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  return picture;
}

Camera camera_above(const Eigen::Vector3d& from, const Eigen::Vector2d& target, PictureSize size, double focal) {
  Camera camera;
  camera.projection.intrinsics = {.width = size.width,
                                  .height = size.height,
                                  .focal_x = focal,
                                  .focal_y = focal,
                                  .centre_x = size.width / 2.0,
                                  .centre_y = size.height / 2.0,
                                  .baseline = 0};
  const Eigen::Vector3d forward = (Eigen::Vector3d(target.x(), target.y(), 0) - from).normalized();
  const Eigen::Vector3d away = forward.head<2>().norm() > 1e-6 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d right = forward.cross(away).normalized();
  camera.field_from_camera.linear() << right, forward.cross(right), forward;
  camera.field_from_camera.translation() = from;
  return camera;
}

Eigen::Isometry3d flat_tag(const Eigen::Vector3d& centre, double turn) {
  return Eigen::Translation3d(centre) * Eigen::AngleAxisd(turn - 90 * kDegree, Eigen::Vector3d::UnitZ());
}

}  // namespace tests
