// foresight-lab calibrate: the place of a sensor by landmarks that a person found in its picture.
#include "robot/app/lab/commands.h"
#include "robot/app/lab/field_options.h"
#include "robot/app/truth/calibrate_sensor.h"
#include "robot/app/truth/opened_sources.h"
#include "robot/core/json_library.h"
#include "robot/truth/calibration/calibration_json.h"
#include "sim/io/rules.h"

namespace robot::app {
namespace {

class CalibrateCommand final : public Command {
 public:
  explicit CalibrateCommand(CLI::App& app)
      : Command(app.add_subcommand("calibrate", "where a sensor of ground truth stands, by a file of clicks")) {
    options().footer(
        "The file of clicks holds pixels of landmarks: {\"clicks\": [{\"landmark\": \"corner +x +y\", \"x\": 12.5, "
        "\"y\": 33}, …]}.\nThe view Ground truth of foresight-lab truth takes the same clicks by the mouse.\nExit "
        "status: 0, 2 for a calibration that is refused or impossible.\nsources:\n" +
        describe_all_sources());
    auto* source = options().add_option("--source", source_, "the sensor or recording, see below");
    auto* clicks = options().add_option("--clicks", clicks_, "file of clicks")->needs(source);
    source->needs(clicks);
    options().add_option("--calibration", truth_.calibration,
                         "file in which a good calibration is saved, for foresight-lab truth; default: none");
    add_field_options(options(), truth_);
    options().add_flag("--landmarks", landmarks_, "list the landmarks of the field [m, field], and do nothing else");
    options().add_flag("--json", json_, "print as JSON");
  }

  int run() override {
    if (landmarks_) return list_landmarks();
    if (source_.empty()) return fail("calibrate: expected --source and --clicks, or --landmarks");
    truth_.sources = {source_};
    const auto calibration = calibrate_sensor(truth_, clicks_);
    if (!calibration) return fail(calibration.error());
    if (json_)
      std::printf("%s\n", truth::to_json(calibration).dump(2).c_str());
    else
      std::fputs(to_text(*calibration).c_str(), stdout);
    if (!calibration->refused.empty()) return fail("the calibration is refused: " + calibration->refused);
    if (!truth_.calibration.empty() && !json_) std::printf("saved        %s\n", truth_.calibration.c_str());
    return kDone;
  }

 private:
  int list_landmarks() const {
    const auto rules = sim::io::load_rules(truth_.rules);
    if (!rules) return fail("--rules: " + rules.error());
    const std::vector<truth::Landmark> landmarks = truth::landmarks_of(rules->field);
    if (json_) {
      std::printf("%s\n", truth::to_json(landmarks).dump(2).c_str());
      return kDone;
    }
    for (const truth::Landmark& landmark : landmarks)
      std::printf("%-31s %7.3f %7.3f\n", landmark.name.c_str(), landmark.position.x(), landmark.position.y());
    return kDone;
  }

  TruthOptions truth_;
  std::string source_;
  std::filesystem::path clicks_;
  bool landmarks_ = false, json_ = false;
};

}  // namespace

std::unique_ptr<Command> calibrate_command(CLI::App& app) { return std::make_unique<CalibrateCommand>(app); }

}  // namespace robot::app
