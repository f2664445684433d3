// Robots and ball in the depth images of one sensor.
//
//   Result<Detector> detector = Detector::create(pose, field);
//   if (!detector) return detector.failure();
//   for (const DepthFrame& frame : empty_field) detector->learn_background(frame);  // better, not necessary
//   const Result<Detections> seen = detector->detect(frame);
#pragma once

#include <optional>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/detection/background.h"
#include "robot/truth/detection/ball_shape_finder.h"
#include "robot/truth/detection/detector_options.h"
#include "robot/truth/detection/ground_grid.h"
#include "robot/truth/detection/orange_ball_finder.h"
#include "robot/truth/detection/sight.h"
#include "robot/truth/frame/detections.h"

namespace robot::truth {

/// A detector for one sensor at one place. Pure: the same images give the same detections. Used by one thread.
/// Detects robots, whether they stand, touch or lie, and one ball. People and goals are no robots.
class Detector {
 public:
  /// Returns an Error for a pose, field or option that is not a number or is far from anything that exists.
  static Result<Detector> create(const SensorPose& pose, const sim::field::Field& field,
                                 const DetectorOptions& options = {});

  /// Takes an image of the empty field into the median of the last 15 such images. From then on, each pixel is compared with
  /// this median instead of a plane: nets, cables and waves of the carpet are no things. The next detect() takes 100 ms.
  Result<void> learn_background(const DepthFrame& frame);

  /// Returns the number of images in this median, at most 15; 0: each pixel is compared with a plane.
  std::size_t background_images() const { return background_.images(); }

  /// Returns the robots and the ball in an image. Returns an Error for an image of another size. `detected_ns` is 0, since
  /// pure code knows no clock. Memory is kept, so that after some images only the list of robots is allocated.
  Result<Detections> detect(const DepthFrame& frame);

 private:
  Detector(const SensorPose& pose, const sim::field::Field& field, const DetectorOptions& options);
  void use_unit(double unit);
  void use_background();
  void scan(const DepthFrame& frame);
  void scan_row(const DepthFrame& frame, int row);
  void add_point(int row, int column, std::uint16_t depth);

  sim::field::Field field_;
  DetectorOptions options_;
  double unit_;  // [m] of the depths in the images
  Sight sight_;
  Background background_;
  bool background_is_new_ = false;
  GroundGrid grid_;
  OrangeBallFinder orange_ball_finder_;
  BallShapeFinder ball_shape_finder_;
  std::vector<int> noticing_;  // columns of a row
};

}  // namespace robot::truth
