// foresight-lab import: a recording in another format becomes a session.
#include <cstdio>

#include "robot/app/import.h"
#include "robot/app/lab/commands.h"
#include "robot/core/json_library.h"

namespace robot::app {
namespace {

class ImportCommand final : public Command {
 public:
  explicit ImportCommand(CLI::App& app)
      : Command(app.add_subcommand("import", "make a session from another program's recording")) {
    options().add_option("format", request_.format, std::string("auto, or ") + kImportFormats)->required();
    options().add_option("file", request_.file, "file of the recording")->required();
    auto* folder = options().add_option_group("where", "one of")->require_option(1);
    folder->add_option("--out", request_.out, "log folder; the session becomes a new folder in it");
    folder->add_option("--session", request_.session, "folder of the session");
    options().add_option("--robot", robot_, "<team>/<player>: name of the robot in the session")->capture_default_str();
    options().add_option("--name", request_.name, "name of the session");
    options()
        .add_option("--yellow", request_.teams.yellow, "ssl_log: number of the yellow team")
        ->check(CLI::Range(0, 255))
        ->capture_default_str();
    options()
        .add_option("--blue", request_.teams.blue, "ssl_log: number of the blue team")
        ->check(CLI::Range(0, 255))
        ->capture_default_str();
    options().add_flag("--find-ball", request_.find_ball,
                       "bhuman2009: add the orange ball of each picture, and a truth by odometry while it lies still");
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    const Result<RobotName> robot_name = parse_robot_name(robot_);
    if (!robot_name) return fail(robot_name.error());
    request_.robot = *robot_name;
    if (request_.name.empty()) request_.name = request_.file.stem().string();
    const Result<Imported> imported = import_recording(request_);
    if (!imported) return fail(imported.error());
    print(imported->session, imported->report);
    return kDone;
  }

 private:
  void print(const std::filesystem::path& folder, const lab::ImportReport& report) const {
    if (json_) {
      const nlohmann::json said = {{"session", folder.string()},
                                   {"messages", report.messages},
                                   {"about", report.about},
                                   {"warnings", report.warnings},
                                   {"damage", report.damage}};
      std::printf("%s\n", said.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
      return;
    }
    for (const auto& [object, count] : report.messages)
      std::printf("%8llu  %s\n", static_cast<unsigned long long>(count), object.c_str());
    if (!report.about.empty()) std::printf("%s\n", report.about.c_str());
    for (const std::string& warning : report.warnings) std::printf("note: %s\n", warning.c_str());
    if (!report.damage.empty()) std::printf("damaged: %s\n", report.damage.c_str());
    std::printf("%s\n", folder.c_str());
  }

  ImportRequest request_;
  std::string robot_ = "0/1";
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> import_command(CLI::App& app) { return std::make_unique<ImportCommand>(app); }

}  // namespace robot::app
