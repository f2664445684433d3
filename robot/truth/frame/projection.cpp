#include "robot/truth/frame/projection.h"

#include <Eigen/LU>

namespace robot::truth {
namespace {

/// Returns the derivative of distort().
Eigen::Matrix2d slope_of(const Lens& lens, const Eigen::Vector2d& straight) {
  const double x = straight.x(), y = straight.y(), square = straight.squaredNorm();
  const double factor = 1 + square * (lens.k1 + square * (lens.k2 + square * lens.k3));
  const double by_square = lens.k1 + square * (2 * lens.k2 + square * 3 * lens.k3);
  Eigen::Matrix2d slope;
  slope << factor + 2 * x * x * by_square + 2 * lens.p1 * y + 6 * lens.p2 * x,
      2 * x * y * by_square + 2 * lens.p1 * x + 2 * lens.p2 * y,  //
      2 * x * y * by_square + 2 * lens.p1 * x + 2 * lens.p2 * y,
      factor + 2 * y * y * by_square + 6 * lens.p1 * y + 2 * lens.p2 * x;
  return slope;
}

}  // namespace

Eigen::Vector2d distort(const Lens& lens, const Eigen::Vector2d& straight) {
  const double x = straight.x(), y = straight.y(), square = straight.squaredNorm();
  const double factor = 1 + square * (lens.k1 + square * (lens.k2 + square * lens.k3));
  return {factor * x + 2 * lens.p1 * x * y + lens.p2 * (square + 2 * x * x),
          factor * y + lens.p1 * (square + 2 * y * y) + 2 * lens.p2 * x * y};
}

std::optional<Eigen::Vector2d> undistort(const Lens& lens, const Eigen::Vector2d& seen) {
  if (lens == Lens{}) return seen;
  constexpr int kMostSteps = 30;
  constexpr double kExact = 1e-12;
  Eigen::Vector2d straight = seen;
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::Matrix2d slope = slope_of(lens, straight);
    // behind the greatest radius the picture is turned inside out
    if (!(slope.determinant() > 0)) return std::nullopt;
    const Eigen::Vector2d error = distort(lens, straight) - seen;
    if (error.squaredNorm() < kExact * kExact) return straight;
    straight -= slope.inverse() * error;
  }
  return std::nullopt;
}

std::optional<Eigen::Vector3d> Projection::ray(const Eigen::Vector2d& pixel) const {
  const auto straight = undistort(lens, {(pixel.x() - intrinsics.centre_x) / intrinsics.focal_x,
                                         (pixel.y() - intrinsics.centre_y) / intrinsics.focal_y});
  if (!straight) return std::nullopt;
  return Eigen::Vector3d(straight->x(), straight->y(), 1);
}

Eigen::Vector2d Projection::pixel(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d seen = distort(lens, point.head<2>() / point.z());
  return {intrinsics.centre_x + intrinsics.focal_x * seen.x(), intrinsics.centre_y + intrinsics.focal_y * seen.y()};
}

bool Projection::shows(const Eigen::Vector3d& point) const {
  if (!(point.z() > 0)) return false;
  const Eigen::Vector2d place = pixel(point);
  if (!(place.x() >= 0 && place.x() <= intrinsics.width && place.y() >= 0 && place.y() <= intrinsics.height))
    return false;
  return slope_of(lens, point.head<2>() / point.z()).determinant() > 0;
}

}  // namespace robot::truth
