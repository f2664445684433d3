#include "robot/app/services/what_if_service.h"

#include <utility>

#include "robot/core/clock.h"
#include "robot/core/json_library.h"
#include "robot/foresight/question.h"

namespace robot::app {
namespace {

using nlohmann::json;

constexpr const char* kName = "/foresight/what_if";
constexpr const char* kStrategiesName = "/foresight/strategies";

json refused(const std::string& sentence) { return net::failure(std::string(kName) + ": " + sentence); }

json answer(const json& request, const net::ClientContext& asker, const std::string& own, const AskForesight& ask) {
  std::string robot = own;
  json asked = request;
  if (const auto named = asked.find("robot"); named != asked.end()) {
    if (!named->is_string()) return refused("'robot' must be a text such as " + own + ", got something else");
    robot = named->get<std::string>();
    asked.erase(named);
  }
  Result<foresight::WhatIf> question = foreseeing::parse_question(asked);
  if (!question) return refused(question.error());
  question->set_asked_by(std::string(foreseeing::kByPeople));
  Result<foresight::Forecast> forecast = ask(robot, *question, asker.playhead_ns);
  if (!forecast) return refused(forecast.error());
  if (!forecast->refusal().empty()) return refused(forecast->reason());
  // includes the time in the queue behind other questions
  forecast->set_answered_ms(static_cast<float>(monotonic_ns() - asker.asked_ns) / 1e6f);
  return {{"ok", true}, {"robot", robot}, {"forecast", foreseeing::to_json(*forecast, true)}};
}

}  // namespace

void add_what_if_service(net::Services& services, const std::string& robot, std::vector<std::string> strategies,
                         AskForesight ask) {
  services.add(kName, net::Services::For::questions,
               [robot, ask = std::move(ask)](const json& request, const net::ClientContext& asker) {
                 return answer(request, asker, robot, ask);
               });
  services.add(kStrategiesName, net::Services::For::everybody,
               [strategies = std::move(strategies)](const json&, const net::ClientContext&) {
                 return json{{"ok", true}, {"strategies", strategies}};
               });
}

}  // namespace robot::app
