#include "robot/truth/tags/lens.h"

#include <Eigen/LU>

namespace robot::truth::tags {
namespace {

/// A distorted point of the plane z = 1, and its derivative by the undistorted point.
struct Distorted {
  Eigen::Vector2d point;
  Eigen::Matrix2d derivative;
};

Distorted distort(const Lens& lens, const Eigen::Vector2d& from) {
  const double x = from.x(), y = from.y(), square = from.squaredNorm();
  const double radial = 1 + square * (lens.k1 + square * lens.k2);
  const double slope = 2 * (lens.k1 + 2 * square * lens.k2);  // of `radial`, times x or y
  const double mixed = slope * x * y + 2 * lens.p1 * x + 2 * lens.p2 * y;
  Distorted result;
  result.point = {x * radial + 2 * lens.p1 * x * y + lens.p2 * (square + 2 * x * x),
                  y * radial + 2 * lens.p2 * x * y + lens.p1 * (square + 2 * y * y)};
  result.derivative << radial + slope * x * x + 2 * lens.p1 * y + 6 * lens.p2 * x, mixed,  //
      mixed, radial + slope * y * y + 2 * lens.p2 * x + 6 * lens.p1 * y;
  return result;
}

}  // namespace

Eigen::Vector3d Lens::ray(const Eigen::Vector2d& pixel) const {
  constexpr int kMostSteps = 20;
  const Eigen::Vector2d seen{(pixel.x() - intrinsics.centre_x) / intrinsics.focal_x,
                             (pixel.y() - intrinsics.centre_y) / intrinsics.focal_y};
  Eigen::Vector2d straight = seen;
  for (int step = 0; step < kMostSteps; ++step) {
    const Distorted at = distort(*this, straight);
    const Eigen::Vector2d correction = at.derivative.inverse() * (seen - at.point);
    straight += correction;
    if (correction.squaredNorm() < 1e-24) break;
  }
  return {straight.x(), straight.y(), 1};
}

Eigen::Vector2d Lens::pixel(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d seen = distort(*this, point.head<2>() / point.z()).point;
  return {intrinsics.centre_x + intrinsics.focal_x * seen.x(), intrinsics.centre_y + intrinsics.focal_y * seen.y()};
}

}  // namespace robot::truth::tags
