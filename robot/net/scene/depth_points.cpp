#include "robot/net/scene/depth_points.h"

#include <algorithm>
#include <array>

#include "robot/net/scene/cloud_points.h"

namespace robot::net {
namespace {

using Sensor = foresight::TruthSensor;

constexpr std::uint32_t kEach = 2;     // [px] between the pixels that become points
constexpr double kFarthest = 12;       // [m]
constexpr double kHighest = 3;         // [m]
constexpr double kMillimetre = 0.001;  // [m]

/// The way of a point from the sensor to the field: its rotation row by row, its place [m].
struct Pose {
  // the sensor's +x, +y, +z are the field's +x, -z, +y
  std::array<double, 9> rotation{1, 0, 0, 0, 0, 1, 0, -1, 0};
  Point3 place;

  Point3 field(double x, double y, double z) const {
    const auto row = [&](std::size_t i) { return rotation[i] * x + rotation[i + 1] * y + rotation[i + 2] * z; };
    return {place.x + row(0), place.y + row(3), place.z + row(6)};
  }
};

Pose pose_of(const Sensor& sensor) {
  Pose pose;
  if (!sensor.has_place() || sensor.place().rotation_size() != 9) return pose;
  const Sensor::SensorPlace& place = sensor.place();
  std::copy(place.rotation().begin(), place.rotation().end(), pose.rotation.begin());
  pose.place = {place.x(), place.y(), place.z()};
  return pose;
}

/// Returns the colour of a height above the carpet [m]: green on the carpet, blue to red above it.
Colour colour_at(double height) {
  if (height < 0.04) return {.red = 0.25, .green = 0.6, .blue = 0.3, .alpha = 1};
  const double share = std::clamp(height / 0.8, 0.0, 1.0);
  return {.red = 0.15 + 0.8 * share, .green = 0.45 - 0.2 * share, .blue = 0.95 - 0.8 * share, .alpha = 1};
}

}  // namespace

Result<std::string> depth_points(const ::foxglove::RawImage& depth, const Sensor& sensor, std::uint64_t capture_ns) {
  const Sensor::Pinhole& pinhole = sensor.pinhole();
  const std::size_t width = depth.width(), height = depth.height();
  if (depth.encoding() != "16UC1" || depth.step() != 2 * width || depth.data().size() != 2 * width * height)
    return Error{"expected a depth image of encoding 16UC1, " + std::to_string(2 * width * height) + " bytes, got '" +
                 depth.encoding() + "' with " + std::to_string(depth.data().size()) + " bytes"};
  if (pinhole.width() != width || pinhole.height() != height || !(pinhole.focal_x() > 0 && pinhole.focal_y() > 0))
    return Error{"expected a pinhole of " + std::to_string(width) + "x" + std::to_string(height) + " px, got " +
                 std::to_string(pinhole.width()) + "x" + std::to_string(pinhole.height())};
  const Pose pose = pose_of(sensor);
  const double unit = kMillimetre * (sensor.has_place() ? double{sensor.place().depth_scale()} : 1.0);
  CloudPoints points;
  points.reserve(width * height / (kEach * kEach));
  for (std::size_t row = 0; row < height; row += kEach)
    for (std::size_t column = 0; column < width; column += kEach) {
      const std::size_t at = 2 * (row * width + column);
      const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(depth.data()[i])}; };
      const double z = unit * (byte(at) | byte(at + 1) << 8);
      if (!(z > 0 && z <= kFarthest)) continue;
      const double x = z * (static_cast<double>(column) + 0.5 - double{pinhole.centre_x()}) / double{pinhole.focal_x()};
      const double y = z * (static_cast<double>(row) + 0.5 - double{pinhole.centre_y()}) / double{pinhole.focal_y()};
      const Point3 place = pose.field(x, y, z);
      if (place.z <= kHighest) points.add(place, colour_at(place.z));
    }
  return points.message(capture_ns);
}

}  // namespace robot::net
