// foresight-lab what-if: the best strategy from a moment of a recording on.
#include <cstdio>
#include <optional>

#include "robot/app/lab/commands.h"
#include "robot/app/lab_foresight.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/foresight/question.h"

namespace robot::app {
namespace {

/// Prints the same table as foresight-sim situation --strategies.
void print(const foresight::Forecast& forecast) {
  std::printf("%-20s%9s%18s%26s%9s%9s%10s\n", "", "futures", "value", "gain, 95 % interval", "best", "scores",
              "concedes");
  for (const auto& told : forecast.strategies()) {
    std::printf("%-20s%9u%9.3f ± %-6.3f", told.strategy().c_str(), told.rollouts(), told.mean(), told.error());
    if (&told == &forecast.strategies(0))
      std::printf("%26s", "");
    else
      std::printf("%9.3f (%6.3f .. %6.3f)", told.gain(), told.gain_low(), told.gain_high());
    std::printf("%7.0f %%%7.0f %%%8.0f %%\n", 100 * told.best(), 100 * told.score(), 100 * told.concede());
  }
  std::printf("\n%s\n", forecast.reason().c_str());
}

class WhatIfCommand final : public Command {
 public:
  explicit WhatIfCommand(CLI::App& app)
      : Command(app.add_subcommand("what-if", "compare strategies from a moment of a session on")) {
    options().add_option("session", what_if_.session, "folder of the session, or an .mcap file")->required();
    options().add_option("--at", what_if_.at, "[s] since the beginning, or negative: before the end")->required();
    options().add_option("--robot", what_if_.robot, "<team>/<player>; default: the robot that recorded the session");
    options()
        .add_option("--strategies", strategies_,
                    "strategies to compare, the first is the one that is played; default: the built-in ones")
        ->delimiter(',');
    options().add_option("--horizon", horizon_, "[s] length of a rollout: 1 .. 1200; default: 30");
    options().add_option("--budget-ms", budget_ms_, "[ms] time for the answer: 10 .. 10000; default: 2000");
    options().add_option("--rules", what_if_.foresight.rules,
                         "rules of a year; default: those of the recorded simulation, else spl2025");
    options().add_option("--question", question_,
                         "other entries of the question, as JSON: {\"until\": \"half\", \"edit\": {...}}");
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    const auto more = parse_json(question_);
    if (!more) return fail("--question: " + more.error());
    auto parsed = foreseeing::parse_question(*more);
    if (!parsed) return fail("--question: " + parsed.error());
    complete(*parsed);
    what_if_.foresight.strategies = {parsed->strategies().begin(), parsed->strategies().end()};
    what_if_.question = *std::move(parsed);
    const auto forecast = what_if(what_if_);
    if (!forecast) return fail(forecast.error());
    if (!forecast->refusal().empty()) return fail(forecast->reason());
    if (json_)
      std::printf("%s\n", foreseeing::to_json(*forecast, true).dump(2).c_str());
    else
      print(*forecast);
    return kDone;
  }

 private:
  /// Puts the options into the question; an option has priority over the same entry of --question.
  void complete(foresight::WhatIf& question) const {
    if (!strategies_.empty()) question.clear_strategies();
    for (const std::string& name : strategies_) question.add_strategies(name);
    if (horizon_ != 0) question.set_horizon(static_cast<float>(horizon_));
    if (budget_ms_ || question.budget_ms() == 0) question.set_budget_ms(budget_ms_.value_or(2000));
  }

  WhatIfOptions what_if_;
  std::string question_ = "{}";
  std::vector<std::string> strategies_;
  double horizon_ = 0;  // [s] 0: not given
  std::optional<std::uint32_t> budget_ms_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> what_if_command(CLI::App& app) { return std::make_unique<WhatIfCommand>(app); }

}  // namespace robot::app
