// foresight-lab synthesize: a small session with every object, for tests and for a first look at the viewer.
#include <cstdio>

#include "robot/app/import.h"
#include "robot/app/lab/commands.h"

namespace robot::app {
namespace {

class SynthesizeCommand final : public Command {
 public:
  explicit SynthesizeCommand(CLI::App& app)
      : Command(app.add_subcommand("synthesize", "make a small session of a synthetic robot")) {
    options().add_option("session", session_, "folder of the session")->required();
    options().add_option("--seconds", seconds_, "[s] length of the session, 1 .. 600")->capture_default_str();
    options().add_option("--robot", robot_, "<team>/<player>")->capture_default_str();
  }

  int run() override {
    const Result<RobotName> robot_name = parse_robot_name(robot_);
    if (!robot_name) return fail(robot_name.error());
    const auto made = synthesize(session_, *robot_name, seconds_);
    if (!made) return fail(made.error());
    std::printf("%s\n", session_.c_str());
    return kDone;
  }

 private:
  std::string session_, robot_ = "14/2";
  double seconds_ = 20;
};

}  // namespace

std::unique_ptr<Command> synthesize_command(CLI::App& app) { return std::make_unique<SynthesizeCommand>(app); }

}  // namespace robot::app
