// The depth image of a ground-truth sensor as points on the field, for viewers that draw point clouds.
#pragma once

#include <cstdint>
#include <string>

#include "proto/foresight/truth.pb.h"
#include "proto/foxglove/RawImage.pb.h"
#include "robot/core/result.h"

namespace robot::net {

/// Returns a serialised foxglove.PointCloud of every second pixel of every second row that has a depth, coloured by height.
/// `depth` is a 16UC1 image [mm] of the sensor. Points farther than 12 m or more than 3 m high are left out. Without a
/// calibrated place the points are in the sensor's own frame, turned so that +z is up. Returns an Error for an image that is
/// not 16UC1, or whose size is not that of the pinhole.
Result<std::string> depth_points(const ::foxglove::RawImage& depth, const foresight::TruthSensor& sensor,
                                 std::uint64_t capture_ns);

}  // namespace robot::net
