// The faults of a Kinect's depth image: noise, rounding to disparities, shadows, dropouts.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/synthetic/cast.h"

namespace robot::truth {

/// A noise model of a sensor with a projector, or of a time-of-flight sensor where the baseline is 0.
/// Source: shared/facts/ground_truth.md section 2, there checked against real planes up to 2.4 m.
class DisparityNoise {
 public:
  DisparityNoise();

  /// Writes the depth image that a sensor with `depth_scale` (true depth / measured depth) measures of `cast`. The size,
  /// the intrinsics and the unit of `frame` are set. Different numbers give different noise.
  void measure(const Cast& cast, double depth_scale, std::uint64_t number, DepthFrame& frame) const;

 private:
  /// Noise of deviation 1. Neighbours within 3 px are alike, as block matching makes them. A table is faster than draws.
  std::vector<float> correlated_;
};

}  // namespace robot::truth
