#include "robot/truth/calibration/calibration_json.h"

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "robot/truth/calibration/json_reader.h"
#include "robot/truth/calibration/place_json.h"

namespace robot::truth {
namespace {

nlohmann::json to_json(const ExpectedError& error) {
  auto grid = nlohmann::json::array();
  for (const ErrorAt& at : error.grid) grid.push_back({{"x", at.x}, {"y", at.y}, {"metres", at.metres}});
  return {{"mean", error.mean}, {"p95", error.p95}, {"grid", std::move(grid)}};
}

nlohmann::json to_json(const LeftOutCheck& check) {
  return {{"mean", check.mean}, {"worst", check.worst}, {"landmark", check.landmark}};
}

}  // namespace

Result<std::vector<Click>> clicks_of(const nlohmann::json& message) {
  JsonReader reader("clicks");
  std::vector<Click> clicks;
  constexpr double kFarthest = 1e5;  // [px]
  for (const auto& entry : reader.list(message, "clicks", kMostClicks))
    clicks.push_back({.landmark = reader.text(entry, "landmark"),
                      .x = reader.number(entry, "x", -kFarthest, kFarthest),
                      .y = reader.number(entry, "y", -kFarthest, kFarthest)});
  if (!reader.good()) return reader.error();
  return clicks;
}

Result<std::vector<Click>> parse_clicks(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.failure("clicks");
  return clicks_of(*json);
}

nlohmann::json to_json(const std::vector<Click>& clicks) {
  auto list = nlohmann::json::array();
  for (const Click& click : clicks) list.push_back({{"landmark", click.landmark}, {"x", click.x}, {"y", click.y}});
  return {{"clicks", std::move(list)}};
}

nlohmann::json to_json(const Result<Calibration>& calibration) {
  if (!calibration) return {{"fitted", false}, {"refused", calibration.error()}};
  auto residuals = nlohmann::json::array();
  for (const ClickResidual& residual : calibration->residuals)
    residuals.push_back(
        {{"landmark", residual.click.landmark}, {"pixels", residual.pixels}, {"outlier", residual.outlier}});
  return {{"fitted", true},
          {"refused", calibration->refused},
          {"residuals", std::move(residuals)},
          {"depth_scale", calibration->pose.depth_scale},
          {"depth_scale_deviation", calibration->scale_deviation},
          {"error", to_json(calibration->robots)},
          {"ball_error", to_json(calibration->ball)},
          {"left_out", to_json(calibration->left_out)},
          {"place", place_to_json(calibration->pose.field_from_sensor)}};
}

nlohmann::json to_json(const std::vector<Landmark>& landmarks) {
  auto list = nlohmann::json::array();
  for (const Landmark& landmark : landmarks)
    list.push_back({{"name", landmark.name},
                    {"x", landmark.position.x()},
                    {"y", landmark.position.y()},
                    {"z", landmark.position.z()}});
  return list;
}

}  // namespace robot::truth
