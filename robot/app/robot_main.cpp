// foresight-robot: the runtime on the robot.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "robot/app/build_id.h"
#include "robot/app/robot_name.h"
#include "robot/app/runtime.h"
#include "robot/app/signals.h"
#include "robot/body/replay/replay.h"

namespace robot::app {
namespace {

constexpr int kDone = 0, kBadInput = 2;

struct RobotOptions {
  std::string body = "replay";
  std::filesystem::path session;
  double speed = 1;
  bool loop = false;
  int team = -1, player = -1;
  std::filesystem::path log_folder = "logs";
  std::uint64_t log_mb = 4000;
  std::string profile = "game", name;
  bool record = false, plan = false;
  ServerSettings server;
};

void add_options(CLI::App& app, RobotOptions& options) {
  app.add_option("--body", options.body, "where sensor data come from: replay")
      ->check(CLI::IsMember({"replay"}))
      ->capture_default_str();
  app.add_option("--session", options.session, "folder of the session that body replay plays");
  app.add_option("--speed", options.speed, "of body replay: 0.01 .. 1000, 1 is real time")->capture_default_str();
  app.add_flag("--loop", options.loop, "body replay begins again at the end");
  app.add_option("--team", options.team, "number of the team; that of the session if not given")
      ->check(CLI::Range(0, 255));
  app.add_option("--player", options.player, "number of the player; that of the session if not given")
      ->check(CLI::Range(1, 99));
  app.add_option("--log-dir", options.log_folder, "where sessions are recorded")->capture_default_str();
  app.add_option("--log-mb", options.log_mb, "what all sessions together may take [MB]; the oldest go first")
      ->capture_default_str();
  app.add_option("--profile", options.profile, "what is recorded: game, vision or full")->capture_default_str();
  app.add_option("--name", options.name, "name of the session that --record begins");
  app.add_flag("--record", options.record, "begin to record at once");
  app.add_flag("--plan", options.plan, "say what each profile takes and whether it fits, then end");
  add_server_options(app, options.server);
}

RuntimeOptions runtime_options(const RobotOptions& options, RobotName robot) {
  return {.program = "foresight-robot",
          .body = options.body,
          .robot = robot.text(),
          .team = robot.team,
          .player = robot.player,
          .server = options.server,
          .log_folder = options.log_folder,
          .log_bytes = options.log_mb * 1'000'000};
}

Result<void> run(const RobotOptions& options) {
  block_end_signals();
  if (options.session.empty()) return Error{"--session: body replay needs the folder of a session"};
  const auto recorded = logging::read_session(options.session);
  if (!recorded) return Error{recorded.error()};
  const RobotName robot{.team = options.team >= 0 ? options.team : recorded->info.team,
                        .player = options.player >= 0 ? options.player : recorded->info.player};
  auto replay = body::Replay::open(options.session, {.speed = options.speed,
                                                     .loop = options.loop,
                                                     .robot = robot.text(),
                                                     // these this process writes about itself
                                                     .skipped_objects = {"runtime", "clock", "log"}});
  if (!replay) return Error{replay.error()};
  const auto memory = std::make_shared<memory::Memory>(robot.text(), (*replay)->clock());
  Runtime runtime(runtime_options(options, robot), (*replay)->clock(),
                  {.runtime = memory->runtime, .clock = memory->clock, .log = memory->log});
  if (Result<void> listed = list(memory, runtime.channels()); !listed) return listed;
  for (const logging::Profile& profile : logging::profiles())
    std::printf("%s\n", runtime.recorder().room_for(profile).sentence.c_str());
  if (options.plan) return {};
  if (Result<void> started = runtime.start(); !started) return started;
  if (options.record)
    if (Result<void> recording = runtime.record(options.name, options.profile); !recording) return recording;
  (*replay)->start(runtime.channels(), runtime.board());
  runtime.run([&] {
    if ((*replay)->tick() == body::Replay::Tick::began_again) runtime.server().restart_time();
    return true;
  });
  (*replay)->stop();
  return {};
}

int robot_main(int argc, char** argv) {
  CLI::App app{"Foresight on the robot"};
  app.set_version_flag("--version", std::string(kBuildId));
  RobotOptions options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  }
  const Result<void> ran = run(options);
  if (ran) return kDone;
  std::fprintf(stderr, "foresight-robot: %s\n", ran.error().c_str());
  return kBadInput;
}

}  // namespace
}  // namespace robot::app

int main(int argc, char** argv) { return robot::app::robot_main(argc, argv); }
