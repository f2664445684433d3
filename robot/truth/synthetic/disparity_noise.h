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

  /// Writes the colours that the sensor shows: shifted by a pixel to the right, since no registration is perfect. One pixel
  /// of 20 of an orange ball has another colour, and one of 100,000 elsewhere is orange.
  static void colour(const Cast& cast, std::uint64_t number, DepthFrame& frame);

 private:
  /// Noise of deviation 1, equal to itself within about 3 px as block matching makes it. Tables are faster than draws.
  std::vector<float> correlated_;
};

}  // namespace robot::truth
