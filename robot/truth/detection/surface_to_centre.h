// The calibration of the one constant of the robots' detection.
#pragma once

#include <vector>

#include "robot/core/result.h"
#include "robot/truth/detection/detector_options.h"
#include "robot/truth/frame/sensor_pose.h"
#include "sim/field/field.h"

namespace robot::truth {

/// An image of a robot that stands with the middle between its feet on a mark.
struct MarkedFrame {
  DepthFrame frame;
  Eigen::Vector2d mark = Eigen::Vector2d::Zero();  // [m, field]
};

/// Returns the value of DetectorOptions::surface_to_centre that is right on average. Five marks with several headings each
/// give it to 2 mm. Returns an Error when no image shows a robot within 0.5 m of its mark.
Result<double> fit_surface_to_centre(const SensorPose& pose, const sim::field::Field& field, DetectorOptions options,
                                     const std::vector<MarkedFrame>& frames);

}  // namespace robot::truth
