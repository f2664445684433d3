// camera.json: a person's knowledge of a sensor that its images do not contain.
//
//   {"width": 640, "height": 480, "focal_x": 384.2, "focal_y": 384.2, "centre_x": 319.5, "centre_y": 236.4,
//    "baseline": 0.05, "unit": 0.001, "rate": 30}
//
// Every entry may be left out. Lengths are in pixels, `baseline` (0: no disparity) and `unit` (one step of the depth) in
// metres, `rate` in images per second. "capture_ns" lists the times of all images in the order of their names, as decimal
// texts of nanoseconds since the epoch.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/frame/depth_frame.h"

namespace robot::truth {

struct CameraFile {
  std::optional<double> width, height;
  std::optional<double> focal_x, focal_y, centre_x, centre_y, baseline;
  std::optional<double> unit, rate;
  std::vector<std::uint64_t> capture_ns;
};

/// Reads the text of a camera.json. Returns an Error that names the wrong entry and its range.
Result<CameraFile> parse_camera_file(std::string_view text);

/// Reads the camera.json at `path`. An Error names the file.
Result<CameraFile> read_camera_file(const std::filesystem::path& path);

/// Replaces those intrinsics and that unit of `frame` that the file contains. Returns an Error if it is about images of
/// another size.
Result<void> apply(const CameraFile& camera, DepthFrame& frame);

}  // namespace robot::truth
