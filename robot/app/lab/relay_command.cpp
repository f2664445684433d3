// foresight-lab relay: live robots, each read over one connection, served to any number of viewers.
#include <map>

#include "robot/app/clock_option.h"
#include "robot/app/lab/commands.h"
#include "robot/app/relay.h"

namespace robot::app {
namespace {

class RelayCommand final : public Command {
 public:
  explicit RelayCommand(CLI::App& app)
      : Command(app.add_subcommand("relay", "serve live robots to any number of viewers, and record them")) {
    options()
        .add_option("robots", relay_.robots,
                    "addresses such as 10.0.14.22:8765, or names or player numbers of the robots file")
        ->required();
    options().add_option("--robots", relay_.robots_file,
                         "the robots file; default: $FORESIGHT_ROBOTS, else ~/.config/foresight/robots.json");
    options()
        .add_option("--pictures", relay_.pictures,
                    "camera images: jpeg (a wireless network can carry them), raw or none")
        ->transform(CLI::CheckedTransformer(std::map<std::string, lab::Pictures>{
            {"jpeg", lab::Pictures::jpeg}, {"raw", lab::Pictures::raw}, {"none", lab::Pictures::none}}))
        ->default_str("jpeg");
    options().add_flag("--lossless", relay_.lossless,
                       "receive every message or lose the connection; default: a slow connection gets the newest");
    add_clock_option(options(), relay_.max_clock_offset);
    add_recording_options(options(), relay_.recording);
    add_server_options(options(), relay_.server);
  }

  int run() override {
    const Result<void> relayed = relay(relay_);
    return relayed ? kDone : fail(relayed.error());
  }

 private:
  RelayOptions relay_;
};

}  // namespace

std::unique_ptr<Command> relay_command(CLI::App& app) { return std::make_unique<RelayCommand>(app); }

}  // namespace robot::app
