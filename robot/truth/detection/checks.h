// The checks of everything that a detector is given.
#pragma once

#include "robot/core/result.h"
#include "robot/truth/detection/detector_options.h"
#include "robot/truth/frame/sensor_pose.h"
#include "sim/field/field.h"

namespace robot::truth {

/// Return an Error for a value that is not a number or is far from anything that exists.
Result<void> check(const SensorPose& pose);
Result<void> check(const sim::field::Field& field);
Result<void> check(const DetectorOptions& options);

/// Returns an Error for an image that does not fit the size of the sensor, or itself.
Result<void> check(const DepthFrame& frame, const Intrinsics& sensor);

}  // namespace robot::truth
