#include "robot/body/nao/config.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>

#include "robot/core/files.h"
#include "robot/core/text.h"
#include "robot/nao/walk/named_parameters.h"

namespace robot::body {
namespace {

constexpr double kGreatestOffset_deg = 20, kGreatestPixels = 5000, kGreatestControl = 1'000'000;
constexpr std::size_t kMaxBytes = 65536;

/// Name and value of one line of the file.
struct Line {
  std::string name, value;
};

Error wrong(const Line& line, const std::string& expected) {
  return Error{"nao config: " + line.name.substr(0, 40) + ": expected " + expected + ", got '" +
               line.value.substr(0, 40) + "'"};
}

/// Reads the value of `line`, times `unit`, into `number`.
Result<void> read_number(const Line& line, double low, double high, double unit, double& number) {
  char* end = nullptr;
  const double value = std::strtod(line.value.c_str(), &end);
  if (end == line.value.c_str() || *end != '\0' || !(value >= low && value <= high))
    return wrong(line, formatted("a number %.7g .. %.7g", low, high));
  number = value * unit;
  return {};
}

Result<void> read_angle(const Line& line, double& angle) {
  return read_number(line, -kGreatestOffset_deg, kGreatestOffset_deg, std::numbers::pi / 180, angle);
}

Result<void> read_pixels(const Line& line, double& pixels) { return read_number(line, 0, kGreatestPixels, 1, pixels); }

Result<void> read_control(const Line& line, const std::string& name, nao::CameraSettings& settings) {
  if (!nao::control_id(name)) return Error{"nao config: there is no '" + line.name.substr(0, 60) + "'"};
  double value = 0;
  if (Result<void> read = read_number(line, -kGreatestControl, kGreatestControl, 1, value); !read) return read;
  if (value != std::floor(value)) return wrong(line, "a whole number");
  settings.controls[name] = static_cast<std::int32_t>(value);
  return {};
}

/// Reads a setting of one camera. `name` is the part after "camera_top.".
Result<void> read_camera(const Line& line, const std::string& name, nao::CameraSettings& settings,
                         nao::Calibration::CameraOffset& offset, Projection& projection) {
  constexpr std::string_view kControl = "control.";
  if (name.starts_with(kControl)) return read_control(line, name.substr(kControl.size()), settings);
  for (const auto& [angle, place] :
       {std::pair{"roll_deg", &offset.roll}, {"tilt_deg", &offset.tilt}, {"pan_deg", &offset.pan}})
    if (name == angle) return read_angle(line, *place);
  for (const auto& [pixels, place] : {std::pair{"focal_x", &projection.focal_x},
                                      {"focal_y", &projection.focal_y},
                                      {"centre_x", &projection.centre_x},
                                      {"centre_y", &projection.centre_y}})
    if (name == pixels) return read_pixels(line, *place);
  if (name == "device") {
    if (line.value.empty()) return wrong(line, "a path");
    settings.device = line.value;
    return {};
  }
  if (name != "turned") return Error{"nao config: there is no '" + line.name.substr(0, 60) + "'"};
  if (line.value != "yes" && line.value != "no") return wrong(line, "yes or no");
  settings.turned = line.value == "yes";
  return {};
}

Result<void> read_walk(const Line& line, const std::string& name, nao::walk::Parameters& walk) {
  const auto place = nao::walk::parameter_named(name);
  if (!place) return Error{"nao config: there is no '" + line.name.substr(0, 60) + "'"};
  const auto [low, high] = nao::walk::range_of(place);
  return read_number(line, low, high, 1, walk.*place);
}

Result<void> read_line(const Line& line, NaoConfig& config) {
  const std::size_t dot = line.name.find('.');
  const std::string whose = line.name.substr(0, dot), name = dot == std::string::npos ? "" : line.name.substr(dot + 1);
  nao::Calibration& calibration = config.calibration;
  if (whose == "camera_top") return read_camera(line, name, config.top, calibration.top, config.top_projection);
  if (whose == "camera_bottom")
    return read_camera(line, name, config.bottom, calibration.bottom, config.bottom_projection);
  if (whose == "walk") return read_walk(line, name, config.walk);
  if (line.name == "body.roll_deg") return read_angle(line, calibration.body_roll);
  if (line.name == "body.pitch_deg") return read_angle(line, calibration.body_pitch);
  return Error{"nao config: there is no '" + line.name.substr(0, 60) + "'"};
}

}  // namespace

NaoConfig::NaoConfig() {
  top.device = "/dev/video-top";
  top.turned = true;
  bottom.device = "/dev/video-bottom";
  for (nao::CameraSettings* camera : {&top, &bottom})
    camera->controls = {
        {"auto_white_balance", 1}, {"contrast", 32}, {"saturation", 64}, {"sharpness", 4}, {"auto_focus", 0}};
}

Result<NaoConfig> parse_nao_config(std::string_view text) {
  NaoConfig config;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos)
      return Error{"nao config: expected NAME = VALUE, got '" + std::string(line.substr(0, 60)) + "'"};
    const Line parts{.name = std::string(trimmed(line.substr(0, sign))),
                     .value = std::string(trimmed(line.substr(sign + 1)))};
    if (Result<void> read = read_line(parts, config); !read) return read.failure();
  }
  return config;
}

Result<NaoConfig> read_nao_config(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, kMaxBytes);
  if (!text) return text.failure();
  return parse_nao_config(*text);
}

}  // namespace robot::body
