// Answers as JSON.
#include <array>
#include <utility>

#include "robot/core/json_library.h"
#include "robot/foresight/question.h"

namespace robot::foreseeing {
namespace {

using nlohmann::json;

// the enumerators of the messages are those of the simulator
using sim::foresight::kMeasureNames;
using sim::foresight::kUntilNames;
constexpr std::array kAdvice = {"none", "keep", "change"};

json points(const google::protobuf::RepeatedField<float>& from) {
  json list = json::array();
  for (const float value : from) list.push_back(value);
  return list;
}

json to_json(const pb::Forecast::StrategyForecast& strategy, bool in_full) {
  json told = {
      {"strategy", strategy.strategy()}, {"rollouts", strategy.rollouts()}, {"mean", strategy.mean()},
      {"error", strategy.error()},       {"score", strategy.score()},       {"concede", strategy.concede()},
      {"gain", strategy.gain()},         {"gain_low", strategy.gain_low()}, {"gain_high", strategy.gain_high()},
      {"best", strategy.best()},         {"raced_on", strategy.raced_on()}};
  if (!in_full) return told;
  told["heat_columns"] = strategy.heat_columns();
  told["heat"] = json::array();
  for (const std::uint32_t count : strategy.heat()) told["heat"].push_back(count);
  told["paths"] = json::array();
  for (const pb::Forecast::Path& path : strategy.paths()) {
    json robots = json::array();
    for (const pb::Forecast::RobotPath& robot : path.robots())
      robots.push_back({{"player", robot.player()}, {"points", points(robot.points())}});
    told["paths"].push_back(
        {{"spacing", path.spacing()}, {"ball", points(path.ball())}, {"robots", std::move(robots)}});
  }
  return told;
}

json to_json(const pb::Forecast::Situation& situation) {
  json bodies = json::array();
  for (const pb::Forecast::Situation::Body& body : situation.bodies())
    bodies.push_back({{"side", body.opponent() ? "opponent" : "own"},
                      {"player", body.player()},
                      {"x", body.x()},
                      {"y", body.y()},
                      {"heading", body.heading()},
                      {"deviation", body.deviation()}});
  return {{"ball",
           {{"x", situation.ball_x()},
            {"y", situation.ball_y()},
            {"deviation", situation.ball_deviation()},
            {"elsewhere", situation.ball_elsewhere()}}},
          {"robots", std::move(bodies)},
          {"own_score", situation.own_score()},
          {"opponent_score", situation.opponent_score()},
          {"seconds_remaining", situation.seconds_remaining()}};
}

}  // namespace

json to_json(const pb::Forecast& forecast, bool in_full) {
  const pb::WhatIf& question = forecast.question();
  json strategies = json::array();
  for (const auto& strategy : forecast.strategies()) strategies.push_back(to_json(strategy, in_full));
  return {{"question",
           {{"strategies", std::vector<std::string>(question.strategies().begin(), question.strategies().end())},
            {"asked_by", question.asked_by()},
            {"opponent", question.opponent()},
            {"measure", kMeasureNames[static_cast<std::size_t>(question.measure())]},
            {"until", kUntilNames[static_cast<std::size_t>(question.until())]},
            {"horizon", question.horizon()},
            {"budget_ms", question.budget_ms()},
            {"switching_cost", question.switching_cost()},
            {"sure", question.sure()}}},
          {"advice", kAdvice[static_cast<std::size_t>(forecast.advice())]},
          {"choice", forecast.choice()},
          {"reason", forecast.reason()},
          {"strategies", std::move(strategies)},
          {"asked_ns", std::to_string(forecast.asked_ns())},
          {"answered_ms", forecast.answered_ms()},
          {"computed_ms", forecast.computed_ms()},
          {"simulated", forecast.simulated()},
          {"horizon", forecast.horizon()},
          {"models", forecast.models()},
          {"opponent_models", forecast.opponent_models()},
          {"rules", forecast.rules()},
          {"situation", to_json(forecast.situation())}};
}

}  // namespace robot::foreseeing
