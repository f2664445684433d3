// foresight-lab plan-fit: what a team should record next, so that foresight-lab fit knows its robots well.
#include <cstdio>

#include "robot/app/fit/evidence_options.h"
#include "robot/app/fit/fits.h"
#include "robot/app/lab/commands.h"
#include "robot/core/json_library.h"
#include "robot/fit/plan.h"

namespace robot::app {
namespace {

nlohmann::ordered_json json_of(const fit::Need& need) {
  return {{"figure", need.figure}, {"kind", need.kind}, {"events", need.events}, {"loose", need.loose},
          {"wanted", need.wanted}, {"unit", need.unit}, {"more", need.more},     {"advice", need.advice}};
}

class PlanFitCommand final : public Command {
 public:
  explicit PlanFitCommand(CLI::App& app)
      : Command(app.add_subcommand("plan-fit", "say what to record next, so that fit knows the robots well")) {
    recordings_.declare(options(), "the recordings so far, as for fit");
    options()
        .add_option("--models", base_, "models with the kicks of the robots: a name or a file")
        ->capture_default_str();
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    const auto evidence = recordings_.gather();
    if (!evidence) return fail(evidence.error());
    const auto needs = needs_of(*evidence, base_);
    if (!needs) return fail(needs.error());
    if (json_) {
      auto all = nlohmann::ordered_json::array();
      for (const fit::Need& need : *needs) all.push_back(json_of(need));
      std::printf("%s\n", all.dump(2).c_str());
      return kDone;
    }
    std::fputs(to_text(*needs).c_str(), stdout);
    for (const std::string& sentence : evidence->left_out) std::printf("left out  %s\n", sentence.c_str());
    return kDone;
  }

 private:
  EvidenceOptions recordings_;
  std::string base_ = "match";
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> plan_fit_command(CLI::App& app) { return std::make_unique<PlanFitCommand>(app); }

}  // namespace robot::app
