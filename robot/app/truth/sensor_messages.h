// Depth images, poses and detections of a sensor as messages. Units and frames are those of the .proto.
//
// Each to_proto clears and fills `message`. All are functions of their arguments, for any thread.
#pragma once

#include "proto/foresight/truth.pb.h"
#include "proto/foxglove/RawImage.pb.h"
#include "robot/core/result.h"
#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/frame/detections.h"
#include "robot/truth/frame/sensor_pose.h"
#include "robot/truth/tags/tagged_robots.h"

namespace robot::app {

namespace pb = foresight;

/// Converts the depths to millimetres; more than 65.535 m is not measured. `frame_id` names the sensor: "truth 1".
void to_proto(const truth::DepthFrame& frame, const std::string& frame_id, ::foxglove::RawImage& message);

/// Converts the colours, if the frame has some. Returns false and fills nothing otherwise.
bool colour_to_proto(const truth::DepthFrame& frame, const std::string& frame_id, ::foxglove::RawImage& message);

void to_proto(const truth::Intrinsics& intrinsics, pb::TruthSensor::Pinhole& message);

/// Converts everything but the expected errors.
void to_proto(const truth::SensorPose& pose, pb::TruthSensor::SensorPlace& message);

/// Fills the robots and the ball of `message`, and nothing else.
void to_proto(const truth::Detections& detections, pb::TruthSensor& message);

void to_proto(const truth::tags::RefusedTags& refused, pb::TruthSensor::RefusedTags& message);

void to_proto(const Eigen::Matrix2d& covariance, pb::GroundTruth::Covariance& message);

/// Returns what to_proto() wrote; `detected_ns` is 0. The tracks refuse places that are not finite.
truth::Detections detections_of(const pb::TruthSensor& message, std::uint64_t capture_ns);

/// Returns the pose that to_proto() wrote, with the pinhole of the message. Returns an Error for numbers that are no pose.
Result<truth::SensorPose> pose_of(const pb::TruthSensor& message);

}  // namespace robot::app
