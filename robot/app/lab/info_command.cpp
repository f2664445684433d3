// foresight-lab info: the contents of sessions, and how well the forecasts in them came true.
#include <cstdio>

#include "robot/app/clock_option.h"
#include "robot/app/forecast_report.h"
#include "robot/app/lab/commands.h"
#include "robot/core/json_library.h"
#include "robot/foresight/scorer.h"
#include "robot/lab/clocks/session_report.h"

namespace robot::app {
namespace {

class InfoCommand final : public Command {
 public:
  explicit InfoCommand(CLI::App& app)
      : Command(app.add_subcommand("info", "describe sessions: objects, counts, rates, gaps, time span, clocks")) {
    options()
        .add_option("sessions", sessions_, "folders of sessions, or .mcap files; the clocks of several are compared")
        ->required();
    add_clock_option(options(), max_clock_offset_);
    options().add_flag("--json", json_, "report as JSON: an object for each session");
  }

  int run() override {
    std::vector<lab::RecordedClock> clocks;
    for (const std::string& session : sessions_) {
      const auto report = lab::inspect(session);
      if (!report) return fail(report.error());
      clocks.push_back(report->clock);
      print(*report);
    }
    const auto most_ns = clock_offset_ns(max_clock_offset_);
    if (!most_ns) return fail(most_ns.error());
    const auto agreements = lab::agree(clocks, *most_ns);
    if (!agreements) return fail(agreements.error());
    for (const lab::Agreement& agreement : *agreements)
      if (!agreement.sentence.empty() && !json_) std::printf("%s\n", agreement.sentence.c_str());
    return kDone;
  }

 private:
  void print(const lab::SessionReport& report) const {
    const auto scores = score_forecasts(report.session);
    if (json_) {
      nlohmann::json all = to_json(report);
      for (const auto& [robot, score] : scores) all["forecasts"][robot] = foreseeing::to_json(score);
      std::printf("%s\n", all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
      return;
    }
    std::printf("%s\n", to_text(report).c_str());
    for (const auto& [robot, score] : scores) {
      const std::string text = foreseeing::to_text(score);
      if (!text.empty()) std::printf("forecasts of %s:\n%s\n", robot.c_str(), text.c_str());
    }
  }

  std::vector<std::string> sessions_;
  double max_clock_offset_ = 60;  // [s]
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> info_command(CLI::App& app) { return std::make_unique<InfoCommand>(app); }

}  // namespace robot::app
