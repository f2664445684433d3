// The projection of a camera: a pinhole behind a lens that bends lines (Brown and Conrady's model).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "robot/truth/frame/depth_frame.h"

namespace robot::truth {

/// The distortion of a lens, as OpenCV and most tools write it. Zeros: none, as in a depth image.
struct Lens {
  double k1 = 0, k2 = 0, k3 = 0;  // radial, of the 2nd, 4th and 6th power of the radius
  double p1 = 0, p2 = 0;          // tangential
  friend bool operator==(const Lens&, const Lens&) = default;
};

/// Returns the place of a straight ray in the picture. Rays and places are x / z and y / z, without focal length.
Eigen::Vector2d distort(const Lens& lens, const Eigen::Vector2d& straight);

/// Returns the straight ray that distort() brings to `seen`. Returns nothing if no ray arrives there: the model of a
/// barrel-shaped lens has a greatest radius.
std::optional<Eigen::Vector2d> undistort(const Lens& lens, const Eigen::Vector2d& seen);

/// A pinhole with a lens. Frame `sensor` as in depth_frame.h.
struct Projection {
  Intrinsics intrinsics;
  Lens lens;

  /// Returns the direction of a pixel's ray, with z = 1, or nothing where the lens shows nothing.
  std::optional<Eigen::Vector3d> ray(const Eigen::Vector2d& pixel) const;
  /// Returns the pixel of a point [m, sensor] with z > 0.
  Eigen::Vector2d pixel(const Eigen::Vector3d& point) const;
  /// Reports whether the picture shows the point [m, sensor].
  bool shows(const Eigen::Vector3d& point) const;
};

}  // namespace robot::truth
