#include "robot/app/robot_options.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "robot/body/sim/sim_body.h"
#include "robot/foresight/foreseer.h"

namespace robot::app {
namespace {

void add_body_options(CLI::App& app, RobotOptions& options) {
  app.add_option("--body", options.body, "where sensor data come from: attached, nao, replay or sim")
      ->check(CLI::IsMember({"attached", "nao", "replay", "sim"}))
      ->capture_default_str();
  app.add_option("--team", options.team, "number of the team; that of the session, or 14, if not given")
      ->check(CLI::Range(0, 255));
  app.add_option("--player", options.player, "number of the player; that of the session, or 2, if not given")
      ->check(CLI::Range(1, 99));
  app.add_option("--speed", options.speed, "of replay: 0.01 .. 1000, of sim: 0.1 .. 100; 1 is real time")
      ->capture_default_str();
  app.add_flag("--loop", options.loop, "begin again at the end: the recording, or another game of the next seed");
  app.add_option("--door", options.door,
                 "socket by which a team's processes join body attached or nao; $FORESIGHT_DOOR, or one of this user's "
                 "if not given");
  app.add_option("--guardian", options.guardian,
                 "link of the guardian for body nao; $FORESIGHT_GUARDIAN, or one of this user's if not given");
  app.add_option(
      "--nao-config", options.nao_config,
      "file of calibration and cameras for body nao (robot/body/nao/config.h); a V6 as it is planned if not given");
  app.add_option("--session", options.session, "folder of the session that body replay plays");
}

void add_simulation_options(CLI::App& app, RobotOptions& options) {
  const char* const group = "Body sim";
  app.add_option("--side", options.side, "which team is the own one: home or away")
      ->check(CLI::IsMember({"home", "away"}))
      ->capture_default_str()
      ->group(group);
  app.add_option("--opponent", options.opponent, "number of the other team")
      ->check(CLI::Range(0, 255))
      ->capture_default_str()
      ->group(group);
  app.add_option("--home", options.home, "strategy of the home team: a name, or the path of a file")
      ->capture_default_str()
      ->group(group);
  app.add_option("--away", options.away, "strategy of the away team")->capture_default_str()->group(group);
  app.add_option("--rules", options.rules,
                 "of a year, in foresight too; spl2012 with body sim if not given, else spl2025")
      ->group(group);
  app.add_option("--models", options.models, "what robots can do and perceive")->capture_default_str()->group(group);
  app.add_option("--home-models", options.home_models, "the home team's own")->group(group);
  app.add_option("--away-models", options.away_models, "the away team's own")->group(group);
  app.add_option("--seed", options.seed, "all chance of the game follows from it")
      ->check(CLI::Range(std::uint64_t{0}, body::SimBody::kGreatestSeed))
      ->capture_default_str()
      ->group(group);
}

void add_foresight_options(CLI::App& app, RobotOptions& options) {
  const char* const group = "Foresight";
  app.add_option("--strategies", options.strategies,
                 "what can be chosen from, by name or path; the first is what is played at first")
      ->delimiter(',')
      ->group(group);
  app.add_flag_callback(
         "--foresight", [&options] { options.foresight = true; }, "the captain asks of its own accord")
      ->group(group);
  app.add_flag_callback(
         "--no-foresight", [&options] { options.foresight = false; },
         "it does not; with body sim it does where nobody says otherwise")
      ->group(group);
}

void add_game_options(CLI::App& app, RobotOptions& options) {
  const char* const group = "Game";
  CLI::Option* const listen = app.add_flag("--game-controller", options.game_controller,
                                           "listen to the GameController, and record each half from READY to FINISHED")
                                  ->group(group);
  app.add_flag("--return-packets", options.return_packets,
               "answer the GameController; not where the team's own code does")
      ->needs(listen)
      ->group(group);
  app.add_flag("--team-messages", options.team_messages,
               "tell the teammates, within the budget; not where the team's own code does")
      ->needs(listen)
      ->group(group);
  app.add_option("--game-port", options.game_port, "where it broadcasts to")->capture_default_str()->group(group);
  app.add_option("--field", options.field, "which field this is, such as A: becomes part of the sessions' names")
      ->group(group);
}

void add_recording_options(CLI::App& app, RobotOptions& options) {
  app.add_option("--log-dir", options.log_folder, "where sessions are recorded")->capture_default_str();
  app.add_option("--log-mb", options.log_mb, "what all sessions together may take [MB]; the oldest go first")
      ->capture_default_str();
  app.add_option("--profile", options.profile, "what is recorded: game, vision or full")->capture_default_str();
  app.add_option("--name", options.name, "name of the session that --record begins");
  app.add_flag("--record", options.record, "begin to record at once");
  app.add_flag("--plan", options.plan, "say what each profile takes and whether it fits, then end");
}

}  // namespace

void add_options(CLI::App& app, RobotOptions& options) {
  add_body_options(app, options);
  add_simulation_options(app, options);
  add_foresight_options(app, options);
  add_game_options(app, options);
  add_recording_options(app, options);
  add_server_options(app, options.server);
}

std::string rules_of(const RobotOptions& options) {
  if (!options.rules.empty()) return options.rules;
  return options.body == "sim" ? "spl2012" : foreseeing::kNewestRules;
}

const std::string& own_strategy_of(const RobotOptions& options) {
  return options.side == "home" ? options.home : options.away;
}

std::set<std::string> written_by_us(const RobotOptions& options) {
  std::set<std::string> objects{"forecast", "forecast_score", "strategy"};
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
                         .server = options.server,
                         .log_folder = options.log_folder,
                         .log_bytes = options.log_mb * 1'000'000};
  const bool may_hear = options.body == "attached" || options.body == "nao";
  if (!options.game_controller && !may_hear) return runtime;
  const auto team = static_cast<std::uint32_t>(robot.team), player = static_cast<std::uint32_t>(robot.player);
  runtime.game = GameOptions{.link = {.team = team,
                                      .player = player,
                                      .return_packets = options.return_packets,
                                      .team_messages = options.team_messages},
                             .field = options.field,
                             .profile = options.profile};
  if (options.game_controller)
    runtime.game->listener = game::ListenerOptions{.team = team, .player = player, .port = options.game_port};
  return runtime;
}

Result<bool> begin(Runtime& runtime, const RobotOptions& options) {
  for (const logging::Profile& profile : logging::profiles())
    std::printf("%s\n", runtime.recorder().room_for(profile).sentence.c_str());
  if (options.plan) return false;
  if (Result<void> started = runtime.start(); !started) return Error{started.error()};
  if (options.record)
    if (Result<void> recording = runtime.record(options.name, options.profile); !recording)
      return Error{recording.error()};
  return true;
}

}  // namespace robot::app
