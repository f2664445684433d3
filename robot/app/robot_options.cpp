#include "robot/app/robot_options.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "robot/body/sim/sim_body.h"
#include "robot/foresight/foreseer.h"

namespace robot::app {
namespace {

void add_body_options(CLI::App& app, RobotOptions& options) {
  app.add_option("--body", options.body, "source of sensor data: attached, nao, replay or sim")
      ->check(CLI::IsMember({"attached", "nao", "replay", "sim"}))
      ->capture_default_str();
  app.add_option("--team", options.team, "number of the team; default: that of the session, else 14")
      ->check(CLI::Range(0, 255));
  app.add_option("--player", options.player, "number of the player; default: that of the session, else 2")
      ->check(CLI::Range(1, 99));
  app.add_option("--speed", options.speed, "speed of body replay (0.01 .. 1000) or sim (0.1 .. 100); 1 is real time")
      ->capture_default_str();
  app.add_flag("--loop", options.loop, "at the end begin again: the recording, or a new game with the next seed");
  app.add_option("--door", options.door,
                 "socket for a team's processes, body attached or nao; default: $FORESIGHT_DOOR, else one per user");
  app.add_option(
      "--behaviour", options.behaviour,
      "our strategy that decides 30 times a second, body attached or nao, by name or path; default: none, a team's "
      "process writes motion_command");
  app.add_option("--guardian", options.guardian,
                 "link of the guardian for body nao; default: $FORESIGHT_GUARDIAN, else one per user");
  app.add_option(
      "--nao-config", options.nao_config,
      "file of calibration and cameras for body nao (robot/body/nao/config.h); default: a V6 without calibration");
  app.add_option("--session", options.session, "folder of the session that body replay plays");
}

void add_simulation_options(CLI::App& app, RobotOptions& options) {
  const char* const group = "Body sim";
  app.add_option("--side", options.side, "side of the own team: home or away")
      ->check(CLI::IsMember({"home", "away"}))
      ->capture_default_str()
      ->group(group);
  app.add_option("--opponent", options.opponent, "number of the other team")
      ->check(CLI::Range(0, 255))
      ->capture_default_str()
      ->group(group);
  app.add_option("--home", options.home, "strategy of the home team: a name or a file")
      ->capture_default_str()
      ->group(group);
  app.add_option("--away", options.away, "strategy of the away team")->capture_default_str()->group(group);
  app.add_option("--rules", options.rules,
                 "rules of a year, also of foresight; default: spl2012 with body sim, else spl2025")
      ->group(group);
  app.add_option(
         "--models", options.models,
         "models of the robots' abilities and perception, also of foresight; default: match, and nao for the own "
         "robot with body nao")
      ->group(group);
  app.add_option("--home-models", options.home_models, "models of the home team")->group(group);
  app.add_option("--away-models", options.away_models, "models of the away team")->group(group);
  app.add_option("--seed", options.seed, "seed of all random numbers of the game")
      ->check(CLI::Range(std::uint64_t{0}, body::SimBody::kGreatestSeed))
      ->capture_default_str()
      ->group(group);
}

void add_foresight_options(CLI::App& app, RobotOptions& options) {
  const char* const group = "Foresight";
  app.add_option("--strategies", options.strategies,
                 "strategies to choose from, by name or path; the first is played at first")
      ->delimiter(',')
      ->group(group);
  app.add_flag_callback(
         "--foresight", [&options] { options.foresight = true; }, "the captain asks by itself")
      ->group(group);
  app.add_flag_callback(
         "--no-foresight", [&options] { options.foresight = false; },
         "the captain does not ask by itself; this is the default except with body sim")
      ->group(group);
}

void add_game_options(CLI::App& app, RobotOptions& options) {
  const char* const group = "Game";
  CLI::Option* const listen = app.add_flag("--game-controller", options.game_controller,
                                           "listen to the GameController, and record each half from READY to FINISHED")
                                  ->group(group);
  app.add_flag("--return-packets", options.return_packets, "answer the GameController; not if the team's own code does")
      ->needs(listen)
      ->group(group);
  app.add_flag("--team-messages", options.team_messages,
               "send team messages, within the budget; not if the team's own code does")
      ->needs(listen)
      ->group(group);
  app.add_flag("--practice", options.practice,
               "games are tests: wireless networks stay open, and other machines may control and download; the viewer "
               "says so on every page")
      ->group(group);
  app.add_option("--game-port", options.game_port, "UDP port of the GameController")
      ->capture_default_str()
      ->group(group);
  app.add_option("--field", options.field, "name of the field, such as A; part of the sessions' names")->group(group);
}

void add_profile_options(CLI::App& app, RobotOptions& options) {
  add_recording_options(app, options.recording);
  app.add_option("--profile", options.profile, "profile of recordings: game, vision or full")->capture_default_str();
  app.add_option("--only", options.only,
                 "objects that recordings contain, such as ball,pose,decision; default: all objects");
  app.add_flag("--plan", options.plan, "print the size of each profile and whether it fits, then end");
}

}  // namespace

void add_options(CLI::App& app, RobotOptions& options) {
  add_body_options(app, options);
  add_simulation_options(app, options);
  add_foresight_options(app, options);
  add_game_options(app, options);
  add_profile_options(app, options);
  add_server_options(app, options.server);
}

std::string rules_of(const RobotOptions& options) {
  if (!options.rules.empty()) return options.rules;
  return options.body == "sim" ? "spl2012" : foreseeing::kNewestRules;
}

std::string own_models_of(const RobotOptions& options) {
  if (!options.models.empty()) return options.models;
  return options.body == "nao" ? "nao" : "match";
}

std::string models_of(const RobotOptions& options, sim::Side side) {
  const std::string& given = side == sim::Side::home ? options.home_models : options.away_models;
  if (!given.empty()) return given;
  if (side == own_side_of(options)) return own_models_of(options);
  return options.models.empty() ? "match" : options.models;
}

sim::Side own_side_of(const RobotOptions& options) {
  return options.side == "home" ? sim::Side::home : sim::Side::away;
}

const std::string& own_strategy_of(const RobotOptions& options) {
  return own_side_of(options) == sim::Side::home ? options.home : options.away;
}

std::set<std::string> written_by_us(const RobotOptions& options) {
  std::set<std::string> objects{"forecast", "forecast_score", "strategy"};
  if (!options.behaviour.empty()) objects.insert({"motion_command", "decision"});
  if (options.game_controller) objects.insert("game");
  if (options.return_packets || options.team_messages) objects.insert("team");
  return objects;
}

RobotName robot_named_by(const RobotOptions& options) {
  return {.team = options.team.value_or(14), .player = options.player.value_or(2)};
}

RuntimeOptions runtime_options(const RobotOptions& options, RobotName robot) {
  RuntimeOptions runtime{.program = "foresight-robot",
                         .body = options.body,
                         .robot = robot.text(),
                         .team = robot.team,
                         .player = robot.player,
                         .rules = rules_of(options),
                         .server = options.server,
                         .log_folder = options.recording.log_folder,
                         .log_bytes = options.recording.log_bytes()};
  // a replay is looked at in its recording
  if (options.body != "replay")
    runtime.recent = options.body == "sim" ? logging::kRecentPastOfTeams : logging::RecentPastLimits{};
  const bool may_hear = options.body == "attached" || options.body == "nao";
  if (!options.game_controller && !may_hear) return runtime;
  const auto team = static_cast<std::uint32_t>(robot.team), player = static_cast<std::uint32_t>(robot.player);
  runtime.game = GameOptions{.link = {.team = team,
                                      .player = player,
                                      .return_packets = options.return_packets,
                                      .team_messages = options.team_messages},
                             .field = options.field,
                             .profile = options.profile,
                             .practice = options.practice};
  if (options.game_controller)
    runtime.game->listener = game::ListenerOptions{.team = team, .player = player, .port = options.game_port};
  return runtime;
}

Result<bool> begin(Runtime& runtime, const RobotOptions& options) {
  if (const auto profile = logging::profile_named(options.profile); !profile) return profile.failure("--profile");
  if (const auto usable = logging::check_session_name(options.recording.name); !usable) return usable.failure("--name");
  if (const auto known = runtime.record_only(options.only); !known) return known.failure("--only");
  for (const logging::Profile& profile : logging::profiles())
    std::printf("%s\n", runtime.recorder().room_for(profile).sentence.c_str());
  if (options.plan) return false;
  if (Result<void> started = runtime.start(); !started) return started.failure();
  if (options.recording.record)
    if (Result<void> recording = runtime.record(options.recording.name, options.profile); !recording)
      return recording.failure();
  return true;
}

}  // namespace robot::app
