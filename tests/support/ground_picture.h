// A depth image of a field, as small as the calibration needs it: a carpet, a wall and boxes, with a sensor's noise.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <random>
#include <vector>

#include "robot/truth/calibration/calibrate.h"

namespace tests {

/// Returns normal numbers that are the same with every standard library (Box and Muller).
double normal_number(std::mt19937& random);

/// An upright box on the carpet, parallel to the axes [m, field].
struct Box {
  double least[2], most[2], height;
};

/// A sensor that looks at a field.
struct GroundScene {
  sim::field::Field field;
  robot::truth::Intrinsics intrinsics;
  Eigen::Isometry3d field_from_sensor = Eigen::Isometry3d::Identity();
  double depth_scale = 1;  // true depth / measured depth
  std::vector<Box> boxes;

  robot::truth::SensorPose pose() const;

  /// Returns the image, with noise if `random` is there.
  robot::truth::DepthFrame depth_image(std::mt19937* random) const;

  /// Returns clicks of all landmarks in the picture, `deviation` [px] beside them.
  std::vector<robot::truth::Click> clicks(std::mt19937& random, double deviation) const;
};

/// Returns the field of 2012, 6 m x 4 m, seen from a mast of 2.1 m that stands 3.2 m beside its middle. Ten landmarks without
/// the feet of posts are in the picture; robots, a referee and a wall, too.
GroundScene mast_scene();

}  // namespace tests
