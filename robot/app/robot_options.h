// The command line of foresight-robot.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "robot/app/recording_settings.h"
#include "robot/app/robot_name.h"
#include "robot/app/runtime.h"
#include "robot/app/server_settings.h"
#include "sim/world/world.h"

namespace robot::app {

/// The options of foresight-robot, with their defaults.
struct RobotOptions {
  std::string body = "replay";
  std::optional<int> team, player;
  double speed = 1;
  bool loop = false;

  // bodies attached and nao
  std::string behaviour;       // our strategy that decides on the robot; empty: a team's process decides
  std::filesystem::path door;  // empty: the default path, where clients look

  // body nao
  std::filesystem::path guardian;    // the guardian's link; empty: the default path
  std::filesystem::path nao_config;  // robot/body/nao/config.h; empty: a V6 without calibration

  // body replay
  std::filesystem::path session;

  // body sim
  std::string side = "home";
  int opponent = 5;
  std::string home = "baseline", away = "baseline";
  std::string rules;                             // also of foresight; empty: the default of rules_of()
  std::string models, home_models, away_models;  // also of foresight; empty: own_models_of()
  std::uint64_t seed = 1;

  // foresight
  std::vector<std::string> strategies;  // empty: default_strategies()
  std::optional<bool> foresight;        // not given: true with body sim only

  // game
  bool game_controller = false, return_packets = false, team_messages = false, practice = false;
  std::uint16_t game_port = game::kControlPort;
  std::string field;

  // recording
  RecordingSettings recording{.log_mb = 4000};
  std::string profile = "game";
  std::string only;  // objects to record, "ball,pose"; empty: all
  bool plan = false;

  ServerSettings server;
};

/// Declares all options of foresight-robot, which set `options`.
void add_options(CLI::App& app, RobotOptions& options);

/// Returns the rules of the game. Without the option they are spl2012 for body sim and the newest rules for other
/// bodies.
std::string rules_of(const RobotOptions& options);

/// Returns the models of the own body. Without the option they are nao for body nao and match for other bodies.
std::string own_models_of(const RobotOptions& options);

/// Returns the models of one side's robots: those given for that side, else own_models_of() for the own side and those of
/// --models, by default match, for the other one.
std::string models_of(const RobotOptions& options, sim::Side side);

/// Returns the side of the own team.
sim::Side own_side_of(const RobotOptions& options);

/// Returns the first strategy of the own side of a simulation.
const std::string& own_strategy_of(const RobotOptions& options);

/// Returns the objects that this process writes with every body: those of foresight, and with --game-controller those
/// of the game.
std::set<std::string> written_by_us(const RobotOptions& options);

/// Returns the robot that the options name, by default 14/2.
RobotName robot_named_by(const RobotOptions& options);

/// Converts the options to those of the runtime.
RuntimeOptions runtime_options(const RobotOptions& options, RobotName robot);

/// Starts the runtime, for every body: prints which profiles fit on the disk and opens the port. With --record it begins
/// to record now, or as soon as the disk permits it. Returns false with --plan, which only prints. Returns an Error for a
/// wrong --profile, --only or --name.
Result<bool> begin(Runtime& runtime, const RobotOptions& options);

}  // namespace robot::app
