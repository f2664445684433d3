// foresight-sim: games of simulated robot soccer, played, measured and compared.
#include "sim/app/commands.h"

namespace sim::app {
namespace {

int sim_main(int argc, char** argv) {
  CLI::App app{"Foresight's simulator of robot soccer"};
  app.set_version_flag("--version", std::string(FORESIGHT_VERSION));
  app.require_subcommand(1);
  robot::command::Commands commands;
  commands.push_back(match_command(app));
  commands.push_back(situation_command(app));
  commands.push_back(replay_command(app));
  commands.push_back(check_command(app));
  commands.push_back(drills_command(app));
  commands.push_back(learn_command(app));
  commands.push_back(why_command(app));
  commands.push_back(whynot_command(app));
  commands.push_back(debug_command(app));
  commands.push_back(coverage_command(app));
  commands.push_back(decisions_command(app));
  commands.push_back(compare_command(app));
  commands.push_back(bench_command(app));
  commands.push_back(calibration_command(app));
  commands.push_back(choosing_command(app));
  commands.push_back(outlook_command(app));
  commands.push_back(vet_command(app));
  commands.push_back(signature_command(app));
  commands.push_back(skills_command(app));
  commands.push_back(features_command(app));
  for (const char* kind : {"rules", "models", "falls", "strategies", "situations"})
    commands.push_back(list_command(app, kind));
  return robot::command::run(app, commands, argc, argv);
}

}  // namespace
}  // namespace sim::app

int main(int argc, char** argv) { return sim::app::sim_main(argc, argv); }
