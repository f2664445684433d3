#include "robot/app/known_game.h"

#include "robot/bridge/from_messages.h"

namespace robot::app {

Result<sim::io::PreparedGame> KnownGame::of(const std::string& robot) {
  const auto simulation = bridge::simulation_of(channels_);
  const auto setting = foreseeing::setting_of(simulation ? &simulation->value : nullptr, robot, rules_);
  if (setting == setting_) return game_;
  auto game = sim::io::prepare({.rules = setting.rules, .models = {setting.models, setting.opponent_models}});
  if (!game) return game.failure();
  setting_ = setting;
  return game_ = *std::move(game);
}

}  // namespace robot::app
