// foresight-lab info: the contents of sessions, how well the forecasts in them came true, and how far from the ground truth
// the beliefs were.
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "robot/app/clock_option.h"
#include "robot/app/forecast_report.h"
#include "robot/app/lab/commands.h"
#include "robot/core/json_library.h"
#include "robot/foresight/scorer.h"
#include "robot/lab/clocks/session_report.h"
#include "robot/lab/clocks/truth_report.h"

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
    const auto most_ns = clock_offset_ns(max_clock_offset_);
    if (!most_ns) return fail(most_ns.error());
    std::vector<lab::SessionReport> reports;
    std::vector<logging::Session> sessions;
    for (const std::string& session : sessions_) {
      auto report = lab::inspect(session);
      if (!report) return fail(report.error());
      sessions.push_back(report->session);
      reports.push_back(std::move(*report));
    }
    const auto times = lab::session_times(sessions, *most_ns);
    std::map<std::size_t, lab::TruthReport> beside_truth;  // by the index of the session
    if (times)
      for (const lab::JudgedRobot& robot : times->robots)
        beside_truth.emplace(robot.session, lab::truth_report(times->truth, robot));
    for (std::size_t i = 0; i < reports.size(); ++i) {
      const auto beside = beside_truth.find(i);
      print(reports[i], beside == beside_truth.end() ? nullptr : &beside->second);
    }
    if (!times) return fail(times.error());
    for (const lab::Agreement& agreement : times->agreements)
      if (!agreement.sentence.empty() && !json_) std::printf("%s\n", agreement.sentence.c_str());
    return kDone;
  }

 private:
  /// Prints the report of a session. `truth`: its beliefs beside ground truth; null without one.
  void print(const lab::SessionReport& report, const lab::TruthReport* truth) const {
    const auto scores = score_forecasts(report.session);
    if (json_) {
      nlohmann::json all = to_json(report);
      for (const auto& [robot, score] : scores) all["forecasts"][robot] = foreseeing::to_json(score);
      if (truth) all["truth"] = to_json(*truth);
      std::printf("%s\n", all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
      return;
    }
    std::printf("%s\n", to_text(report).c_str());
    for (const auto& [robot, score] : scores) {
      const std::string text = foreseeing::to_text(score);
      if (!text.empty()) std::printf("forecasts of %s:\n%s\n", robot.c_str(), text.c_str());
    }
    if (truth) std::printf("%s\n", to_text(*truth).c_str());
  }

  std::vector<std::string> sessions_;
  double max_clock_offset_ = 60;  // [s]
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> info_command(CLI::App& app) { return std::make_unique<InfoCommand>(app); }

}  // namespace robot::app
