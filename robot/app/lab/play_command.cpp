// foresight-lab play: recordings, served to viewers as if they were live.
#include "robot/app/clock_option.h"
#include "robot/app/lab/commands.h"
#include "robot/app/play.h"

namespace robot::app {
namespace {

class PlayCommand final : public Command {
 public:
  explicit PlayCommand(CLI::App& app)
      : Command(app.add_subcommand("play", "serve sessions to browsers, Foxglove and Lichtblick")) {
    options()
        .add_option("sessions", play_.sessions,
                    "folders of sessions, or .mcap files; those of several robots are played in one time base")
        ->required();
    options().add_option("--speed", play_.speed, "0.01 .. 1000, 1 is real time")->capture_default_str();
    options().add_flag("--loop", play_.loop, "begin again at the end");
    add_clock_option(options(), play_.max_clock_offset);
    options().add_option("--map", play_.map,
                         "JSON file that maps other programs' topics to our objects: robot/lab/mapping/mapping.h");
    options().add_option("--rules", play_.foresight.rules,
                         "rules for what-if questions; default: those of the recorded simulation, else spl2025");
    options()
        .add_option("--strategies", play_.foresight.strategies,
                    "more strategies for what-if questions, by name or path; the first is the one that was played")
        ->delimiter(',');
    add_server_options(options(), play_.server);
  }

  int run() override {
    const Result<void> played = play(play_);
    return played ? kDone : fail(played.error());
  }

 private:
  PlayOptions play_;
};

}  // namespace

std::unique_ptr<Command> play_command(CLI::App& app) { return std::make_unique<PlayCommand>(app); }

}  // namespace robot::app
