// The agreement of a depth image with a ball on the carpet.
#pragma once

#include <Eigen/Core>

#include "robot/truth/detection/sight.h"
#include "robot/truth/frame/depth_frame.h"

namespace robot::truth {

/// The measured pixels in and around the image of a ball.
struct BallAgreement {
  double evidence = 0;  // for a ball and against the empty field, in squares of the noise; at most 9 of each pixel
  int pixels = 0;       // within the ball's image
  int fitting = 0;      // of these: within three standard deviations of its surface
  int around = 0;       // above its middle, outside of its image
  int clear = 0;        // of these: more like the empty field than like a thing at the ball's depth

  /// Reports whether it looks like a ball. Noise alone reaches 2 of each pixel somewhere in every tenth image.
  bool convincing() const {
    constexpr double kLeast = 100;  // small images need more of each pixel
    return fitting > 0.85 * pixels && clear > 0.75 * around && evidence > 2.2 * pixels && evidence > kLeast;
  }
};

/// Compares the depths around a ball [m, sensor] with those of the ball on the empty field. Of a near ball, not all pixels
/// are tried, but all are counted.
BallAgreement ball_agreement(const Sight& sight, const DepthFrame& frame, const Eigen::Vector3d& centre, double radius);

}  // namespace robot::truth
