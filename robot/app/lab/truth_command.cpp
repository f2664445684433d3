// foresight-lab truth: sensors beside the field report where ball and robots are.
#include "robot/app/clock_option.h"
#include "robot/app/lab/commands.h"
#include "robot/app/lab/field_options.h"
#include "robot/app/truth/opened_sources.h"
#include "robot/app/truth/watch_truth.h"

namespace robot::app {
namespace {

class TruthCommand final : public Command {
 public:
  explicit TruthCommand(CLI::App& app)
      : Command(app.add_subcommand("truth",
                                   "watch the field with depth cameras: ground truth for viewers and recordings")) {
    options().footer("sources:\n" + describe_all_sources() +
                     "  ssl-vision       packets of SSL-Vision; or ssl-vision:GROUP:PORT\n"
                     "  door             a process of your own, such as robot/client/examples/truth.py");
    options()
        .add_option("--source", truth_.sources, "a sensor or a recording, see below; once for each sensor")
        ->required();
    options().add_option("--calibration", truth_.calibration,
                         "file with the places of the sensors; the viewer's view Ground truth makes and improves it");
    options().add_option("--tags", truth_.tags, "file with the printed tags on the robots, for ordinary cameras");
    add_field_options(options(), truth_);
    options().add_flag("!--no-orange", truth_.orange_ball, "the ball has no colour of its own: find it by its shape");
    options().add_option("--home", truth_.home, "strategy of the simulated game")->capture_default_str();
    options().add_option("--away", truth_.away, "strategy of the simulated game")->capture_default_str();
    options().add_option("--models", truth_.models, "models of the simulated game")->capture_default_str();
    options().add_option("--seed", truth_.seed, "seed of the simulated game")->capture_default_str();
    options().add_option("--yellow", truth_.teams.yellow, "team of SSL-Vision's yellow robots")->capture_default_str();
    options().add_option("--blue", truth_.teams.blue, "team of SSL-Vision's blue robots")->capture_default_str();
    options().add_option("--interface", truth_.interface, "network interface of SSL-Vision's packets; default: all");
    options().add_option("--door", truth_.door, "socket of --source door; default: that of a robot's door");
    options().add_option(
        "--robot", truth_.robots,
        "a live robot, as relay names it; once for each: its pose says which robot of the truth it is");
    options().add_option("--robots", truth_.robots_file,
                         "the robots file; default: $FORESIGHT_ROBOTS, else ~/.config/foresight/robots.json");
    add_clock_option(options(), truth_.max_clock_offset);
    options().add_flag("--record-images", truth_.record_images,
                       "recordings contain images too: 18 MB a second and sensor");
    add_recording_options(options(), truth_.recording);
    add_server_options(options(), truth_.server);
  }

  int run() override {
    const Result<void> watched = watch_truth(truth_);
    return watched ? kDone : fail(watched.error());
  }

 private:
  TruthOptions truth_;
};

}  // namespace

std::unique_ptr<Command> truth_command(CLI::App& app) { return std::make_unique<TruthCommand>(app); }

}  // namespace robot::app
