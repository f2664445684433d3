// foresight-lab: imports, describes, plays and questions recordings, relays live robots and watches the field, on the lab's machine.
#include "robot/app/build_id.h"
#include "robot/app/lab/commands.h"

namespace robot::app {
namespace {

int lab_main(int argc, char** argv) {
  CLI::App app{"Foresight on the lab machine"};
  app.set_version_flag("--version", std::string(kBuildId));
  app.require_subcommand(1);
  command::Commands commands;
  commands.push_back(import_command(app));
  commands.push_back(info_command(app));
  commands.push_back(play_command(app));
  commands.push_back(relay_command(app));
  commands.push_back(truth_command(app));
  commands.push_back(calibrate_command(app));
  commands.push_back(fit_command(app));
  commands.push_back(plan_fit_command(app));
  commands.push_back(smooth_command(app));
  commands.push_back(what_if_command(app));
  commands.push_back(situation_command(app));
  commands.push_back(redecide_command(app));
  commands.push_back(game_statistics_command(app));
  commands.push_back(synthesize_command(app));
  return command::run(app, commands, argc, argv);
}

}  // namespace
}  // namespace robot::app

int main(int argc, char** argv) { return robot::app::lab_main(argc, argv); }
