#include "robot/truth/calibration/sensor_json.h"

#include <Eigen/Eigenvalues>

#include "robot/core/json_library.h"
#include "robot/truth/calibration/calibration_json.h"
#include "robot/truth/calibration/place_json.h"

namespace robot::truth {
namespace {

constexpr double kMostPixels = 1e5;
constexpr double kMostVariance = 1e6;

nlohmann::json intrinsics_to_json(const Intrinsics& it) {
  return {{"width", it.width},       {"height", it.height},     {"focal_x", it.focal_x},  {"focal_y", it.focal_y},
          {"centre_x", it.centre_x}, {"centre_y", it.centre_y}, {"baseline", it.baseline}};
}

Intrinsics read_intrinsics(JsonReader& reader, const nlohmann::json& entry) {
  constexpr int kMostSize = 16384;  // [px]
  return {.width = reader.whole(entry, "width", 1, kMostSize),
          .height = reader.whole(entry, "height", 1, kMostSize),
          .focal_x = reader.number(entry, "focal_x", 1, kMostPixels),
          .focal_y = reader.number(entry, "focal_y", 1, kMostPixels),
          .centre_x = reader.number(entry, "centre_x", -kMostPixels, kMostPixels),
          .centre_y = reader.number(entry, "centre_y", -kMostPixels, kMostPixels),
          .baseline = reader.number(entry, "baseline", 0, 10)};
}

nlohmann::json lens_to_json(const Lens& lens) {
  return {{"k1", lens.k1}, {"k2", lens.k2}, {"k3", lens.k3}, {"p1", lens.p1}, {"p2", lens.p2}};
}

Lens read_lens(JsonReader& reader, const nlohmann::json& entry) {
  const auto coefficient = [&](const char* key) { return reader.number(entry, key, -1000, 1000); };
  return {.k1 = coefficient("k1"),
          .k2 = coefficient("k2"),
          .k3 = coefficient("k3"),
          .p1 = coefficient("p1"),
          .p2 = coefficient("p2")};
}

using PoseCovariance = decltype(SensorPose::covariance);

PoseCovariance read_covariance(JsonReader& reader, const nlohmann::json& entry) {
  const std::vector<double> numbers =
      reader.numbers(entry, "covariance", PoseCovariance::SizeAtCompileTime, kMostVariance);
  PoseCovariance covariance = Eigen::Map<const PoseCovariance>(numbers.data());
  // rounding may leave an eigenvalue a little below 0
  const double rounding = 1e-9 * covariance.norm();
  const Eigen::SelfAdjointEigenSolver<PoseCovariance> solver(covariance);
  if (!covariance.isApprox(covariance.transpose(), 1e-9) || solver.eigenvalues().minCoeff() < -rounding)
    reader.refuse("'covariance' must be a symmetric matrix without negative eigenvalues");
  return covariance;
}

nlohmann::json clicks_to_json(const std::vector<ClickResidual>& clicks) {
  auto list = nlohmann::json::array();
  for (const auto& [click, pixels, outlier] : clicks)
    list.push_back(
        {{"landmark", click.landmark}, {"x", click.x}, {"y", click.y}, {"pixels", pixels}, {"outlier", outlier}});
  return list;
}

std::vector<ClickResidual> read_click_residuals(JsonReader& reader, const nlohmann::json& entry) {
  std::vector<ClickResidual> clicks;
  for (const auto& click : reader.list(entry, "clicks", kMostClicks))
    clicks.push_back({.click = {.landmark = reader.text(click, "landmark"),
                                .x = reader.number(click, "x", -kMostPixels, kMostPixels),
                                .y = reader.number(click, "y", -kMostPixels, kMostPixels)},
                      .pixels = reader.number(click, "pixels", 0, kMostPixels),
                      .outlier = reader.truth(click, "outlier")});
  return clicks;
}

}  // namespace

nlohmann::json sensor_to_json(const SensorCalibration& sensor) {
  const PoseCovariance& covariance = sensor.pose.covariance;
  return {{"address", sensor.address},
          {"field", sensor.field},
          {"intrinsics", intrinsics_to_json(sensor.intrinsics)},
          {"fitted_intrinsics", intrinsics_to_json(sensor.pose.intrinsics)},
          {"lens", lens_to_json(sensor.lens)},
          {"place", place_to_json(sensor.pose.field_from_sensor)},
          {"depth_scale", sensor.pose.depth_scale},
          {"covariance", std::vector<double>(covariance.data(), covariance.data() + covariance.size())},
          {"clicks", clicks_to_json(sensor.clicks)},
          {"error", {{"mean", sensor.error_mean}, {"p95", sensor.error_p95}}}};
}

SensorCalibration read_sensor(JsonReader& reader, const nlohmann::json& entry) {
  constexpr double kMostError = 1000;  // [m]
  const nlohmann::json& error = reader.object(entry, "error");
  return {.address = reader.text(entry, "address"),
          .field = reader.text(entry, "field"),
          .intrinsics = read_intrinsics(reader, reader.object(entry, "intrinsics")),
          .pose = {.intrinsics = read_intrinsics(reader, reader.object(entry, "fitted_intrinsics")),
                   .field_from_sensor = read_place(reader, reader.object(entry, "place")),
                   .depth_scale = reader.number(entry, "depth_scale", 0.5, 2),
                   .covariance = read_covariance(reader, entry)},
          .lens = read_lens(reader, reader.object(entry, "lens")),
          .clicks = read_click_residuals(reader, entry),
          .error_mean = reader.number(error, "mean", 0, kMostError),
          .error_p95 = reader.number(error, "p95", 0, kMostError)};
}

}  // namespace robot::truth
