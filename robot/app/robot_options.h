// The command line of foresight-robot.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "robot/app/robot_name.h"
#include "robot/app/runtime.h"
#include "robot/app/server_settings.h"

namespace robot::app {

struct RobotOptions {
  std::string body = "replay";
  std::optional<int> team, player;
  double speed = 1;
  bool loop = false;

  // bodies attached and nao
  std::filesystem::path door;  // empty: where clients look for it

  // body nao
  std::filesystem::path guardian;    // its link; empty: where it is by itself
  std::filesystem::path nao_config;  // robot/body/nao/config.h; empty: a V6 as it is planned

  // body replay
  std::filesystem::path session;

  // body sim
  std::string side = "home";
  int opponent = 5;
  std::string home = "baseline", away = "baseline";
  std::string rules;                                       // of foresight, too; empty: rules_of()
  std::string models = "match", home_models, away_models;  // of foresight, too
  std::uint64_t seed = 1;

  // foresight
  std::vector<std::string> strategies;  // empty: default_strategies()
  std::optional<bool> foresight;        // nothing: with body sim alone

  // game
  bool game_controller = false, return_packets = false, team_messages = false;
  std::uint16_t game_port = game::kControlPort;
  std::string field;

  // recording
  std::filesystem::path log_folder = "logs";
  std::uint64_t log_mb = 4000;
  std::string profile = "game", name;
  bool record = false, plan = false;

  ServerSettings server;
};

void add_options(CLI::App& app, RobotOptions& options);

/// The rules that are played by: where the options name none, a simulation's are those of 2012, a robot's the newest.
std::string rules_of(const RobotOptions& options);

/// What the own side of a simulation plays at first.
const std::string& own_strategy_of(const RobotOptions& options);

/// Objects of our robot that foresight and, as the options ask for it, following a real game write whatever the body.
std::set<std::string> written_by_us(const RobotOptions& options);

/// The robot that the options name: 14/2 where they do not.
RobotName robot_named_by(const RobotOptions& options);

RuntimeOptions runtime_options(const RobotOptions& options, RobotName robot);

/// What every body does first: says what fits on the disk, opens the port, begins to record if it should.
/// False: that was all that was asked for (--plan).
Result<bool> begin(Runtime& runtime, const RobotOptions& options);

}  // namespace robot::app
