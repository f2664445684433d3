// Settings of one robot: mounting of head and torso, devices and controls of the cameras, numbers of the walk.
#pragma once

#include <filesystem>
#include <string_view>

#include "robot/core/result.h"
#include "robot/nao/camera/video_capture.h"
#include "robot/nao/model/kinematics.h"
#include "robot/nao/walk/parameters.h"

namespace robot::body {

/// Projection of a camera, for images of the size in its settings.
struct Projection {
  // [px] between the values that two teams calibrated on the V6: 619 (B-Human), 608 (HULKs)
  double focal_x = 614, focal_y = 614;
  double centre_x = 320, centre_y = 240;
};

/// All settings of one robot.
struct NaoConfig {
  nao::Calibration calibration;
  nao::CameraSettings top, bottom;
  Projection top_projection, bottom_projection;
  nao::walk::Parameters walk;

  /// Defaults of the V6: /dev/video-top, mounted upside down, /dev/video-bottom, and the usual first controls of teams.
  NaoConfig();
};

/// Reads settings from lines such as
///
///   # offsets from the model of the robot [degrees], -20 .. 20
///   body.pitch_deg = 1.5
///   camera_top.tilt_deg = -0.3
///   camera_top.control.gain = 40
///   walk.period = 0.26
///
/// The names are body.roll_deg and body.pitch_deg; for each of camera_top and camera_bottom:
/// - device (a path), turned (yes or no);
/// - roll_deg, tilt_deg, pan_deg;
/// - focal_x, focal_y, centre_x, centre_y [px];
/// - control.NAME, with a name of control_id();
/// and walk.NAME for each of robot/nao/walk/parameters.h, between a quarter of its default and four times that.
///
/// Missing settings keep the values of NaoConfig(). Returns an Error that names the wrong line. Pure.
Result<NaoConfig> parse_nao_config(std::string_view text);

/// Reads the settings from a file, as parse_nao_config() does.
Result<NaoConfig> read_nao_config(const std::filesystem::path& path);

}  // namespace robot::body
