// A detector that watches synthetic scenes.
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "robot/truth/detection/detector.h"
#include "robot/truth/synthetic/renderer.h"
#include "tests/robot/truth/synthetic/hall.h"

namespace robot::truth {

/// A sensor and the detector that knows its pose. Its image has half of the usual pixels in each direction, to save time.
class Watched {
 public:
  explicit Watched(const SensorPose& pose = mast(kField2012, -1, 0, kHalf),
                   const DetectorOptions& options = {.colour_shift_x = 1}, RenderOptions render = {})
      : renderer_(pose, kHall, render), detector_(*Detector::create(pose, kField2012, options)) {}

  DepthFrame frame(const Scene& scene, std::uint64_t number = 1) { return renderer_.render(scene, number); }
  Detections see(const DepthFrame& frame) {
    const Result<Detections> seen = detector_.detect(frame);
    EXPECT_TRUE(seen) << seen.error();
    return seen ? *seen : Detections{};
  }
  Detections see(const Scene& scene, std::uint64_t number = 1) { return see(frame(scene, number)); }
  Detector& detector() { return detector_; }

 private:
  Renderer renderer_;
  Detector detector_;
};

/// Returns the distance of the nearest seen robot from a place [m].
inline double nearest_robot(const Detections& seen, double x, double y) {
  double nearest = 1e9;
  for (const SeenRobot& robot : seen.robots)
    nearest = std::min(nearest, (robot.place.position - Eigen::Vector2d(x, y)).norm());
  return nearest;
}

/// Returns the squared error of a place in units of its covariance: 2 on average when the covariance is honest.
inline double normalised_error_squared(const Place& place, double x, double y) {
  const Eigen::Vector2d error = place.position - Eigen::Vector2d(x, y);
  return error.dot(place.covariance.inverse() * error);
}

}  // namespace robot::truth
