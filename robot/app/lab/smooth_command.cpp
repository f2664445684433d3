// foresight-lab smooth: the ground truth of a recording, better than it was live, with the names of recorded robots.
#include "robot/app/clock_option.h"
#include "robot/app/lab/commands.h"
#include "robot/app/truth/smooth_session.h"

namespace robot::app {
namespace {

class SmoothCommand final : public Command {
 public:
  explicit SmoothCommand(CLI::App& app)
      : Command(app.add_subcommand("smooth", "make recorded ground truth better, and say which robot is which")) {
    options()
        .add_option("truth", smooth_.truth, "folder of a recording of foresight-lab truth, or an .mcap file")
        ->required();
    options().add_option("robots", smooth_.robots, "recordings of robots of the same game");
    options().add_option("--session", smooth_.session,
                         "folder: the copy with the smoothed truth; default: beside the truth, with _smoothed");
    add_clock_option(options(), smooth_.max_clock_offset);
  }

  int run() override {
    const auto smoothed = smooth_session(smooth_);
    if (!smoothed) return fail(smoothed.error());
    std::fputs(to_text(*smoothed).c_str(), stdout);
    return kDone;
  }

 private:
  SmoothOptions smooth_;
};

}  // namespace

std::unique_ptr<Command> smooth_command(CLI::App& app) { return std::make_unique<SmoothCommand>(app); }

}  // namespace robot::app
