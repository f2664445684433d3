// The command line of foresight-robot.
#pragma once

#include <CLI/CLI.hpp>
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

  // body attached
  std::filesystem::path door;  // empty: where clients look for it

  // body replay
  std::filesystem::path session;

  // body sim
  std::string side = "home";
  int opponent = 5;
  std::string home = "baseline", away = "baseline";
  std::string rules = "spl2012", models = "match", home_models, away_models;
  std::uint64_t seed = 1;

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

/// Objects of our robot that following a real game writes, as the options ask for it.
std::set<std::string> written_by_game(const RobotOptions& options);

/// The robot that the options name: 14/2 where they do not.
RobotName robot_named_by(const RobotOptions& options);

RuntimeOptions runtime_options(const RobotOptions& options, RobotName robot);

/// What every body does first: says what fits on the disk, opens the port, begins to record if it should.
/// False: that was all that was asked for (--plan).
Result<bool> begin(Runtime& runtime, const RobotOptions& options);

}  // namespace robot::app
