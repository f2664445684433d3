#include "robot/truth/sensor/camera_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "robot/core/files.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "robot/truth/sensor/image.h"

namespace robot::truth {
namespace {

constexpr std::size_t kMaxCameraFileBytes = 64'000'000;  // with the times of a day's images

/// A number of camera.json and the range of its values.
struct CameraEntry {
  std::string_view name;
  std::optional<double> CameraFile::*member;
  double least, most;
};

constexpr std::array<CameraEntry, 9> kCameraEntries = {{
    {"width", &CameraFile::width, 1, kMaxSide},
    {"height", &CameraFile::height, 1, kMaxSide},
    {"focal_x", &CameraFile::focal_x, 1, 100000},
    {"focal_y", &CameraFile::focal_y, 1, 100000},
    {"centre_x", &CameraFile::centre_x, -100000, 100000},
    {"centre_y", &CameraFile::centre_y, -100000, 100000},
    {"baseline", &CameraFile::baseline, 0, 10},
    {"unit", &CameraFile::unit, 1e-6, 1},
    {"rate", &CameraFile::rate, 0.001, 10000},
}};

Result<void> read_number_entry(const CameraEntry& entry, const nlohmann::json& value, CameraFile& camera) {
  const double number = value.is_number() ? value.get<double>() : 0;
  if (!value.is_number() || number < entry.least || number > entry.most)
    return Error{formatted("\"%s\" must be a number from %g to %g, got ", entry.name.data(), entry.least, entry.most) +
                 shown(value)};
  camera.*entry.member = number;
  return {};
}

Result<void> read_capture_times(const nlohmann::json& value, CameraFile& camera) {
  const Error wrong{"\"capture_ns\" must be a list of decimal texts of nanoseconds since the epoch"};
  if (!value.is_array()) return wrong;
  for (const nlohmann::json& entry : value) {
    const std::string* text = entry.get_ptr<const std::string*>();
    if (!text) return wrong;
    std::uint64_t time = 0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), time);
    if (error != std::errc() || end != text->data() + text->size()) return wrong;
    camera.capture_ns.push_back(time);
  }
  return {};
}

Result<void> read_entry(const std::string& name, const nlohmann::json& value, CameraFile& camera) {
  if (name == "capture_ns") return read_capture_times(value, camera);
  const auto entry = std::find_if(kCameraEntries.begin(), kCameraEntries.end(),
                                  [&](const CameraEntry& known) { return known.name == name; });
  if (entry == kCameraEntries.end()) return Error{"\"" + printable(name, 40) + "\" is no entry of a camera file"};
  return read_number_entry(*entry, value, camera);
}

}  // namespace

Result<CameraFile> parse_camera_file(std::string_view text) {
  const Result<nlohmann::json> json = parse_json(text);
  if (!json) return json.failure();
  if (!json->is_object()) return Error{"expected a JSON object, got something else"};
  CameraFile camera;
  for (const auto& [name, value] : json->items())
    if (const Result<void> read = read_entry(name, value, camera); !read) return read.failure();
  return camera;
}

Result<CameraFile> read_camera_file(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, kMaxCameraFileBytes);
  if (!text) return text.failure();
  Result<CameraFile> camera = parse_camera_file(*text);
  if (!camera) return camera.failure(path.string());
  return camera;
}

Result<void> apply(const CameraFile& camera, DepthFrame& frame) {
  Intrinsics& intrinsics = frame.intrinsics;
  const double width = camera.width.value_or(intrinsics.width), height = camera.height.value_or(intrinsics.height);
  if (width != intrinsics.width || height != intrinsics.height)
    return Error{formatted("expected %gx%g px, for which the camera file is made, got %dx%d", width, height,
                           intrinsics.width, intrinsics.height)};
  intrinsics.focal_x = camera.focal_x.value_or(intrinsics.focal_x);
  intrinsics.focal_y = camera.focal_y.value_or(intrinsics.focal_y);
  intrinsics.centre_x = camera.centre_x.value_or(intrinsics.centre_x);
  intrinsics.centre_y = camera.centre_y.value_or(intrinsics.centre_y);
  intrinsics.baseline = camera.baseline.value_or(intrinsics.baseline);
  frame.unit = camera.unit.value_or(frame.unit);
  return {};
}

}  // namespace robot::truth
