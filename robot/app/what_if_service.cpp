#include "robot/app/what_if_service.h"

#include <utility>

#include "robot/foresight/question.h"

namespace robot::app {
namespace {

using nlohmann::json;

constexpr const char* kName = "/foresight/what_if";

json refused(const std::string& sentence) { return net::failure(std::string(kName) + ": " + sentence); }

json answer(json request, const std::string& own, const AskForesight& ask) {
  std::string robot = own;
  if (const auto named = request.find("robot"); named != request.end()) {
    if (!named->is_string()) return refused("'robot' must be a text such as " + own + ", got something else");
    robot = named->get<std::string>();
    request.erase(named);
  }
  Result<foresight::WhatIf> question = foreseeing::parse_question(request);
  if (!question) return refused(question.error());
  question->set_asked_by(std::string(foreseeing::kByPeople));
  const Result<foresight::Forecast> forecast = ask(robot, *question);
  if (!forecast) return refused(forecast.error());
  if (!forecast->refusal().empty()) return refused(forecast->reason());
  return {{"ok", true}, {"robot", robot}, {"forecast", foreseeing::to_json(*forecast, true)}};
}

}  // namespace

void add_what_if(net::Services& services, const std::string& robot, AskForesight ask) {
  services.add(kName, net::Services::For::questions,
               [robot, ask = std::move(ask)](const json& request, const net::ClientContext&) {
                 return answer(request, robot, ask);
               });
}

}  // namespace robot::app
