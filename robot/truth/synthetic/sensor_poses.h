// Places from which a synthetic sensor looks at a field.
#pragma once

#include "robot/truth/frame/sensor_pose.h"
#include "sim/field/field.h"

namespace robot::truth {

/// Returns the exact pose of a sensor at `eye` that looks at `target` [m, field], with the horizon level in the image.
/// `eye` is not straight above or below `target`.
SensorPose looking(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const Intrinsics& intrinsics = {});

/// Returns the pose of a sensor on a mast of 2.1 m, 1.2 m behind the touch line at y < 0 (`side` -1) or y > 0 (`side` +1).
/// It looks straight across the field at `x` [m], to a place 3.4 m before it. On the field of 2012 it is 3.2 m behind the
/// middle of the field.
SensorPose mast(const sim::field::Field& field, double side = -1, double x = 0, const Intrinsics& intrinsics = {});

}  // namespace robot::truth
