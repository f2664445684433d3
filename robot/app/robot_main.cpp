// foresight-robot: the runtime on the robot.

#include <CLI/CLI.hpp>
#include <cstdio>

#include "robot/app/build_id.h"
#include "robot/app/given_back.h"
#include "robot/app/robot_options.h"
#include "robot/app/run_attached.h"
#include "robot/app/run_nao.h"
#include "robot/app/run_replay.h"
#include "robot/app/run_simulation.h"
#include "robot/app/signals.h"
#include "robot/core/attempt.h"

namespace robot::app {
namespace {

constexpr int kDone = 0, kBadInput = 2;

Result<void> run(const RobotOptions& options) {
  if (!options.behaviour.empty() && options.body != "attached" && options.body != "nao")
    return Error{"--behaviour: expected --body attached or nao, got " + options.body};
  if (options.body == "attached") return run_attached(options);
  if (options.body == "nao") return run_nao(options);
  return options.body == "sim" ? run_simulation(options) : run_replay(options);
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
  give_images_back();
  block_end_signals();
  const Result<void> ran = attempt("the program", [&] { return run(options); });
  if (ran) return kDone;
  std::fprintf(stderr, "foresight-robot: %s\n", ran.error().c_str());
  return kBadInput;
}

}  // namespace
}  // namespace robot::app

int main(int argc, char** argv) { return robot::app::robot_main(argc, argv); }
