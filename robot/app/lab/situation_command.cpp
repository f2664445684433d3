// foresight-lab situation: a moment of a recording as the start of simulated games.
#include <cstdio>

#include "robot/app/lab/commands.h"
#include "robot/app/recorded_moment.h"
#include "robot/core/files.h"

namespace robot::app {
namespace {

class SituationCommand final : public Command {
 public:
  explicit SituationCommand(CLI::App& app)
      : Command(app.add_subcommand("situation", "a moment of a session, as a robot believed it, for foresight-sim")) {
    options().add_option("session", session_, "folder of the session, or an .mcap file")->required();
    options().add_option("--at", moment_.at, "[s] since the beginning, or negative: before the end")->required();
    options().add_option("--robot", moment_.robot, "<team>/<player>; default: the robot that recorded the session");
    options().add_option("--rules", moment_.rules,
                         "rules of a year; default: those of the recorded simulation, else spl2025");
    options().add_option("--out", out_, "file; default: standard output");
    options().footer(
        "Play it with foresight-sim match --from FILE. With --fuzz each game varies it by its deviations: by what the\n"
        "robot was unsure of.");
  }

  int run() override {
    const auto session = logging::open_session(session_);
    if (!session) return fail(session.error());
    const auto situation = situation_at(*session, moment_);
    if (!situation) return fail(situation.error());
    if (out_.empty())
      std::fputs(situation->c_str(), stdout);
    else if (const auto written = replace_file(out_, *situation); !written)
      return fail(written.error());
    return kDone;
  }

 private:
  RecordedMoment moment_;
  std::string session_, out_;
};

}  // namespace

std::unique_ptr<Command> situation_command(CLI::App& app) { return std::make_unique<SituationCommand>(app); }

}  // namespace robot::app
