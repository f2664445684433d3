#include "robot/lab/clocks/truth_report.h"

#include <cmath>

#include "robot/core/json_library.h"
#include "robot/core/text.h"

namespace robot::lab {
namespace {

constexpr double kPpm = 1e6;

Result<BeliefErrors> ball_errors(const TruthRecord& truth, const JudgedRobot& robot) {
  const auto own = own_path(truth, robot);
  if (!own) return own.failure();
  return belief_errors(truth, *own, robot.record, robot.offset->clock);
}

nlohmann::json json_of(const TruthOffset& offset) {
  nlohmann::json json{{"offset_ns", std::to_string(to_clock_offset(offset.clock).offset_ns)},
                      {"error_ns", std::to_string(to_clock_offset(offset.clock).error_ns)},
                      {"by", offset.by}};
  if (offset.clock.drift_deviation > 0) {
    json["drift_ppm"] = offset.clock.drift * kPpm;
    json["drift_error_ppm"] = kTwoSided * offset.clock.drift_deviation * kPpm;
    json["drift_applied"] = offset.clock.drifts();
  }
  return json;
}

}  // namespace

TruthReport truth_report(const TruthRecord& truth, const JudgedRobot& robot) {
  return {.robot = robot.record.name, .offset = robot.offset, .ball = ball_errors(truth, robot)};
}

std::string to_text(const TruthReport& report) {
  std::string text = report.robot + " beside the ground truth\n";
  if (!report.offset) return text + "clock    its offset is not known: " + report.offset.error() + "\n";
  text += formatted("clock    %s, by %s\n", to_text(to_clock_offset(report.offset->clock)).c_str(),
                    report.offset->by.c_str());
  if (const std::string drift = drift_text(report.offset->clock); !drift.empty()) text += "drift    " + drift + "\n";
  if (!report.ball) return text + "ball     it is not compared: " + report.ball.error() + "\n";
  return text + "ball     distance from the truth:\n" + to_text(*report.ball);
}

nlohmann::json to_json(const TruthReport& report) {
  nlohmann::json json{{"robot", report.robot}};
  if (report.offset)
    json["clock"] = json_of(*report.offset);
  else
    json["clock"] = {{"refused", report.offset.error()}};
  if (report.ball)
    json["ball"] = to_json(*report.ball);
  else
    json["ball"] = {{"refused", report.ball.error()}};
  return json;
}

}  // namespace robot::lab
