// An orange ball in the colours of a depth image.
#pragma once

#include <optional>

#include "robot/truth/detection/ball_plane.h"
#include "robot/truth/detection/detector_options.h"
#include "robot/truth/detection/orange_test.h"
#include "robot/truth/detection/sight.h"
#include "robot/truth/frame/detections.h"

namespace robot::truth {

/// A search on a lattice of pixels that is finer than the radius of a ball's image, so that no ball is missed and few pixels
/// are read. The middle of the orange pixels is the ball's bearing.
class OrangeBallFinder {
 public:
  OrangeBallFinder(const SensorPose& pose, const DetectorOptions& options);

  /// Returns the orange patch whose size fits a ball best. The depths there must not contradict it.
  std::optional<SeenBall> find(const Sight& sight, const DepthFrame& frame) const;

 private:
  struct Candidate {
    SeenBall ball;
    double filled;  // orange part of the area that a ball's image has
  };
  std::optional<Candidate> candidate_at(const Sight& sight, const DepthFrame& frame,
                                        const Eigen::Vector2d& pixel) const;

  /// Returns the radius of a ball's image [px] at the end of a row where it is smaller, or 0 above the horizon.
  double smallest_radius(Sight::Columns columns, int row) const;

  BallPlane plane_;
  OrangeTest is_orange_;
  Eigen::Vector2d colour_shift_;  // [px]
  double colour_deviation_;       // [px]
};

}  // namespace robot::truth
