#include "robot/truth/detection/checks.h"

#include <string>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

/// A number with the range that it must be in.
struct Bounded {
  const char* name;
  double value, least, most;
};

/// Returns an Error for the first number outside of its range. A value that is not a number is in no range.
Result<void> check_all(const char* place, std::initializer_list<Bounded> numbers) {
  for (const Bounded& number : numbers)
    if (!(number.least <= number.value && number.value <= number.most))
      return Error{
          formatted("%s: %s must be %g .. %g, got %g", place, number.name, number.least, number.most, number.value)};
  return {};
}

}  // namespace

Result<void> check(const SensorPose& pose) {
  const Intrinsics& image = pose.intrinsics;
  if (const Result<void> checked =
          check_all("pose of the sensor", {{"width [px]", static_cast<double>(image.width), 16, 4096},
                                           {"height [px]", static_cast<double>(image.height), 16, 4096},
                                           {"focal length x [px]", image.focal_x, 8, 1e5},
                                           {"focal length y [px]", image.focal_y, 8, 1e5},
                                           {"optical axis x [px]", image.centre_x, -1e4, 1e4},
                                           {"optical axis y [px]", image.centre_y, -1e4, 1e4},
                                           {"baseline [m]", image.baseline, 0, 10},
                                           {"depth scale", pose.depth_scale, 0.5, 2}});
      !checked)
    return checked.failure();
  const Eigen::Vector3d place = pose.field_from_sensor.translation();
  if (const Result<void> checked = check_all(
          "pose of the sensor",
          {{"x [m]", place.x(), -100, 100}, {"y [m]", place.y(), -100, 100}, {"height [m]", place.z(), 0.2, 50}});
      !checked)
    return checked.failure();
  const Eigen::Matrix3d turned = pose.field_from_sensor.linear();
  const double skew = (turned * turned.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (!(skew < 1e-3) || turned.determinant() < 0)
    return Error{"pose of the sensor: expected a rotation, got a matrix that is none"};
  return {};
}

Result<void> check(const sim::field::Field& field) {
  Result<void> result;
  sim::field::Field::visit(field, [&](const char* name, float value, const char*, float least, float most) {
    if (result && !(least <= value && value <= most))
      result = Error{formatted("field: %s must be %g .. %g [m], got %g", name, static_cast<double>(least),
                               static_cast<double>(most), static_cast<double>(value))};
  });
  return result;
}

Result<void> check(const DetectorOptions& options) {
  return check_all("detection", {{"ball radius [m]", options.ball_radius, 0.01, 0.2},
                                 {"hue [deg]", options.orange.least_hue_deg, 0, 60},
                                 {"hue [deg]", options.orange.most_hue_deg, 0, 60},
                                 {"saturation", options.orange.least_saturation, 0, 1},
                                 {"brightness", options.orange.least_brightness, 0, 1},
                                 {"shift of the colours [px]", options.colour_shift_x, -100, 100},
                                 {"shift of the colours [px]", options.colour_shift_y, -100, 100},
                                 {"deviation of the colours [px]", options.colour_deviation, 0, 100},
                                 {"height of a robot [m]", options.robot_height, 0.3, 1.5},
                                 {"distance from surface to centre [m]", options.surface_to_centre, -0.3, 0.3},
                                 {"deviation of the posture [m]", options.posture_deviation, 0, 0.3}});
}

Result<void> check(const DepthFrame& frame, const Intrinsics& sensor) {
  const Intrinsics& image = frame.intrinsics;
  if (image.width != sensor.width || image.height != sensor.height)
    return Error{formatted("depth image: the pose of the sensor is for %d x %d pixels, got %d x %d", sensor.width,
                           sensor.height, image.width, image.height)};
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (frame.depth.size() != pixels)
    return Error{formatted("depth image: expected %zu depths, got %zu", pixels, frame.depth.size())};
  if (!frame.rgb.empty() && frame.rgb.size() != 3 * pixels)
    return Error{
        formatted("depth image: expected %zu bytes of colours or none, got %zu", 3 * pixels, frame.rgb.size())};
  return check_all("depth image", {{"unit [m]", frame.unit, 1e-5, 0.1}});
}

}  // namespace robot::truth
