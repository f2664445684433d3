#include "robot/foresight/game_setting.h"

#include "robot/foresight/foreseer.h"
#include "sim/io/source.h"

namespace robot::foreseeing {
namespace {

std::string models_called(const std::string& name) { return sim::io::is_embedded("models", name) ? name : "match"; }

}  // namespace

GameSetting setting_of(const foresight::Simulation* simulation, const std::string& robot, const std::string& rules) {
  GameSetting setting{.rules = kNewestRules, .models = "match", .opponent_models = "match"};
  if (simulation && !simulation->rules().empty()) {
    const foresight::SimulatedTeam &home = simulation->home(), &away = simulation->away();
    const bool is_home = robot.starts_with(std::to_string(home.number()) + "/");
    setting = {.rules = simulation->rules(),
               .models = models_called((is_home ? home : away).models()),
               .opponent_models = models_called((is_home ? away : home).models())};
  }
  if (!rules.empty()) setting.rules = rules;
  return setting;
}

}  // namespace robot::foreseeing
