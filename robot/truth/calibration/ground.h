// The carpet in a depth image.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/frame/projection.h"

namespace robot::truth {

/// The plane of the carpet in the frame `sensor`, at measured depths: points with normal · point + height = 0.
struct Ground {
  Eigen::Vector3d normal = -Eigen::Vector3d::UnitY();  // upwards, of length 1
  double height = 0;                                   // [m] of the sensor above the plane

  /// All pixels of the carpet in four numbers. The squared length of roots * (normal, height) is a sum over the pixels: of
  /// their squared distances from that plane, each by its deviation.
  Eigen::Matrix4d roots = Eigen::Matrix4d::Zero();
  int pixels = 0;  // their number: some thousand, far enough from each other to have independent noise
};

/// Finds the plane that most clicked pixels lie on, and of such planes the one with most pixels of the image. Robots, people
/// and walls do not pull it: pixels farther from it than their noise are left out. Returns an Error if there is none.
Result<Ground> find_ground(const DepthFrame& frame, const Lens& lens, const std::vector<Eigen::Vector2d>& clicks);

}  // namespace robot::truth
