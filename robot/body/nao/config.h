// What is set for one robot: how its head and torso are mounted, its cameras and how they are driven.
#pragma once

#include <filesystem>
#include <string_view>

#include "robot/core/result.h"
#include "robot/nao/camera/video_capture.h"
#include "robot/nao/model/kinematics.h"

namespace robot::body {

/// How a camera projects, for images of the size of its settings.
struct Projection {
  // [px] between what two teams calibrated on the V6: 619 (B-Human), 608 (HULKs)
  double focal_x = 614, focal_y = 614;
  double centre_x = 320, centre_y = 240;
};

struct NaoConfig {
  nao::Calibration calibration;
  nao::CameraSettings top, bottom;
  Projection top_projection, bottom_projection;

  /// The V6's: /dev/video-top, which is mounted upside down, and /dev/video-bottom; controls as teams start from.
  NaoConfig();
};

/// Reads lines such as
///
///   # what this robot is off its plan [degrees], -20 .. 20
///   body.pitch_deg = 1.5
///   camera_top.tilt_deg = -0.3
///   camera_top.control.gain = 40
///
/// There are body.roll_deg, body.pitch_deg and, of camera_top and camera_bottom each: device (a path), turned (yes or no),
/// roll_deg, tilt_deg, pan_deg, focal_x, focal_y, centre_x, centre_y [px], and control.NAME with the names of control_id().
/// What is not said is as NaoConfig() has it. An Error says which line is wrong. Pure.
Result<NaoConfig> parse_nao_config(std::string_view text);

Result<NaoConfig> read_nao_config(const std::filesystem::path& path);

}  // namespace robot::body
