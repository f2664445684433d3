// The calibration of a sensor from clicked landmarks and the carpet in its depth image.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/calibration/expected_error.h"
#include "robot/truth/calibration/ground.h"
#include "robot/truth/calibration/landmarks.h"
#include "robot/truth/frame/projection.h"
#include "robot/truth/frame/sensor_pose.h"

namespace robot::truth {

/// A landmark that a person found in the picture. Pixels as in depth_frame.h.
struct Click {
  std::string landmark;  // the name of a Landmark
  double x = 0, y = 0;   // [px]
};

struct CalibrationOptions {
  double click_deviation = 1;           // [px] one standard deviation of each coordinate of a click
  double depth_scale_deviation = 0.01;  // before the calibration, around 1
  double largest_error = 0.05;          // [m] a calibration whose expected p95 error is greater is refused
  double robot_height = 0.3;            // [m] of the measured points of a robot
  double ball_radius = 0.05;            // [m]
  bool focal_free = false;              // fits the focal length, known to 20 %; for a camera without depths
  bool k1_free = false;                 // fits the first distortion of the lens, known to 0.3
};

/// The miss of one landmark.
struct ClickResidual {
  Click click;
  double pixels = 0;     // [px] distance of the click from the landmark in the picture
  bool outlier = false;  // too far to be the error of a careful click, so that it does not count
};

/// The independent check: each landmark's click, placed on the carpet by a calibration without this landmark.
struct LeftOutCheck {
  double mean = 0, worst = 0;  // [m] distance from the landmark's true place
  std::string landmark;        // the worst one
};

struct Calibration {
  SensorPose pose;                       // with the fitted focal length
  Lens lens;                             // with the fitted k1
  double scale_deviation = 0;            // one standard deviation of pose.depth_scale
  std::vector<ClickResidual> residuals;  // in the order of the clicks
  LeftOutCheck left_out;
  ExpectedError robots;  // by depth; by bearing and height if there is no depth image
  ExpectedError ball;    // by bearing and the plane of its centre
  std::string refused;   // the reason why it is too poor to be used, and what would help; empty: good
};

/// Calibrates a sensor. Without `ground` (a colour camera) the landmarks alone determine the pose. Needs no guess of the pose;
/// single wrong clicks are found. A calibration that could be computed but must not be used has the reason in `refused`.
///
/// Returns an Error if there is no calibration to report. Each landmark must be known, clicked once, and in the picture. At
/// least four are needed, and they must not lie near one line or fit a mirrored field.
Result<Calibration> calibrate(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks,
                              const Projection& camera, const std::optional<Ground>& ground,
                              const CalibrationOptions& options = {});

/// Calibrates the sensor of a depth image. An image without depths counts as a colour camera's.
Result<Calibration> calibrate(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks,
                              const DepthFrame& frame, const CalibrationOptions& options = {}, const Lens& lens = {});

}  // namespace robot::truth
