// The lens of an ordinary camera: a pinhole and its distortion.
#pragma once

#include <Eigen/Core>

#include "robot/truth/frame/depth_frame.h"

namespace robot::truth::tags {

/// A pinhole with the distortion of Brown and Conrady: k1 and k2 along the radius, p1 and p2 of a tilted lens. These are
/// OpenCV's formulas and names. Frame `camera`: +x right in the image, +y down, +z forward.
struct Lens {
  Intrinsics intrinsics;
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0;  // [-] all 0: no distortion

  /// Returns the direction of a pixel's ray in the frame `camera`, with z = 1.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;

  /// Returns the pixel of a point in the frame `camera`. The point is in front of the camera: z > 0.
  Eigen::Vector2d pixel(const Eigen::Vector3d& point) const;
};

}  // namespace robot::truth::tags
