// The rules and models of the game in which a robot plays.
#pragma once

#include <string>

#include "proto/foresight/sim.pb.h"

namespace robot::foreseeing {

/// Names, as on the command line.
struct GameSetting {
  std::string rules;
  std::string models;           // of the robot's own side
  std::string opponent_models;  // of the other side

  bool operator==(const GameSetting&) const = default;
};

/// Returns the setting of `robot` ("14/2") in a simulation, live or recorded. nullptr, or one without rules: a real game by
/// the newest rules. Models that no longer exist become "match". `rules` replace the rules, unless they are empty.
GameSetting setting_of(const foresight::Simulation* simulation, const std::string& robot, const std::string& rules);

}  // namespace robot::foreseeing
