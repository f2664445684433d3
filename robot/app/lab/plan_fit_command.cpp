// foresight-lab plan-fit: what a team should record next, so that foresight-lab fit knows its robots well.
#include <cstdio>

#include "robot/app/clock_option.h"
#include "robot/app/fit/fits.h"
#include "robot/app/lab/commands.h"
#include "robot/core/json_library.h"
#include "robot/fit/plan.h"

namespace robot::app {
namespace {

nlohmann::ordered_json json_of(const fit::Need& need) {
  return {{"figure", need.figure}, {"kind", need.kind}, {"events", need.events}, {"loose", need.loose},
          {"wanted", need.wanted}, {"more", need.more}, {"advice", need.advice}};
}

class PlanFitCommand final : public Command {
 public:
  explicit PlanFitCommand(CLI::App& app)
      : Command(app.add_subcommand("plan-fit", "say what to record next, so that fit knows the robots well")) {
    options().add_option("sessions", sessions_, "what was recorded so far, as for fit")->required();
    options().add_option("--truth", truths_, "recordings of ground truth of the same games");
    options()
        .add_option("--models", base_, "models with the kicks of the robots: a name or a file")
        ->capture_default_str();
    options().add_flag("--json", json_, "report as JSON");
    add_clock_option(options(), max_clock_offset_);
  }

  int run() override {
    const auto most_ns = clock_offset_ns(max_clock_offset_);
    if (!most_ns) return fail(most_ns.error());
    const auto evidence = fit::gather(sessions_, truths_, *most_ns);
    if (!evidence) return fail(evidence.error());
    const auto facts = kick_facts(base_);
    if (!facts) return fail(facts.error());
    const std::vector<fit::Need> needs = fit::plan(*evidence, *facts);
    if (json_) {
      auto all = nlohmann::ordered_json::array();
      for (const fit::Need& need : needs) all.push_back(json_of(need));
      std::printf("%s\n", all.dump(2).c_str());
      return kDone;
    }
    std::fputs(to_text(needs).c_str(), stdout);
    for (const std::string& sentence : evidence->left_out) std::printf("left out  %s\n", sentence.c_str());
    return kDone;
  }

 private:
  std::vector<std::filesystem::path> sessions_, truths_;
  std::string base_ = "match";
  double max_clock_offset_ = 60;  // [s]
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> plan_fit_command(CLI::App& app) { return std::make_unique<PlanFitCommand>(app); }

}  // namespace robot::app
