// The coordinate frames of robots and cameras, and the projection of cameras, for other viewers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/foresight/camera.pb.h"
#include "robot/net/scene/game_scene.h"

namespace robot::net {

/// Returns a serialised foxglove.FrameTransforms with the frame of a robot in the frame field, or nothing if the pose
/// cannot be drawn.
std::optional<std::string> robot_transform(std::string_view frame, const GroundPose& pose, std::uint64_t capture_ns);

/// Returns a serialised foxglove.FrameTransforms with the frame of a camera in its robot's, or nothing if the matrix is
/// no rotation.
std::optional<std::string> camera_transform(std::string_view robot_frame, std::string_view camera_frame,
                                            const foresight::CameraMatrix& matrix, std::uint64_t capture_ns);

/// Returns a serialised foxglove.CameraCalibration, or nothing if the matrix has no usable projection.
std::optional<std::string> camera_calibration(std::string_view camera_frame, const foresight::CameraMatrix& matrix,
                                              std::uint64_t capture_ns);

}  // namespace robot::net
