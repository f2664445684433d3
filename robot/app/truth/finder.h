// The ways to find robots and ball in an image of a calibrated sensor.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "robot/app/truth/calibrations.h"
#include "robot/core/result.h"
#include "robot/truth/detection/background.h"
#include "robot/truth/detection/detector_options.h"
#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/frame/detections.h"
#include "robot/truth/tags/ball_colour.h"
#include "robot/truth/tags/tag_plan.h"
#include "robot/truth/tags/tagged_robots.h"
#include "robot/truth/tracks/sensor.h"
#include "sim/field/field.h"

namespace robot::app {

/// The finder of a sensor at one place. Used by one thread.
class PlacedFinder {
 public:
  PlacedFinder() = default;
  PlacedFinder(const PlacedFinder&) = delete;
  PlacedFinder& operator=(const PlacedFinder&) = delete;
  virtual ~PlacedFinder() = default;

  /// Returns the robots and the ball in an image. Returns an Error for an image of another size than the calibration.
  virtual Result<truth::Detections> find(const truth::DepthFrame& frame) = 0;

  /// Images that replace the whole background.
  static constexpr std::size_t kBackgroundImages = truth::Background::kMost;

  /// Takes an image of the empty field, with which later ones are compared. Returns an Error for an image of another size,
  /// and if it does not compare depths.
  virtual Result<void> learn_background(const truth::DepthFrame& frame);

  /// Returns the number of images of the empty field that are in use, up to kBackgroundImages.
  virtual std::size_t background_images() const { return 0; }

  /// Returns the counts of tags that gave no robot, or nothing if it reads no tags.
  virtual std::optional<truth::tags::RefusedTags> refused() const { return {}; }
};

/// A kind of sensor.
struct Finder {
  /// Returns the finder of a sensor at this place. Returns an Error for a place that cannot be used.
  std::function<Result<std::unique_ptr<PlacedFinder>>(const PlacedSensor&)> at;
  truth::Ranging robots = truth::Ranging::depth;  // the way in which it measures the places of robots
};

/// Returns the finder of a depth camera.
Finder depth_finder(const sim::field::Field& field, const truth::DetectorOptions& options);

/// Returns the finder of an ordinary camera, whose images have colours and no depths: robots by their printed tags, the ball
/// by its colour, if `ball` is there.
Finder tag_finder(const truth::tags::TagPlan& plan, const std::optional<truth::tags::BallLook>& ball);

}  // namespace robot::app
