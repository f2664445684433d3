// foresight-sim drills: short games that practise and measure one thing.
#include <cstdio>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/progress.h"
#include "sim/drills/trials.h"
#include "sim/io/source.h"

namespace sim::app {
namespace {

class DrillsCommand final : public Command {
 public:
  explicit DrillsCommand(CLI::App& app)
      : Command(app.add_subcommand("drills", "short games that practise and measure one thing")) {
    options().require_subcommand(1);
    list_ = options().add_subcommand("list", "list the built-in drills");
    list_->add_flag("--json", json_, "report as JSON");
    show_ = options().add_subcommand("show", "print a drill as a template");
    show_->add_option("drill", drill_, "name or file of the drill")->required();
    run_ = options().add_subcommand("run", "play a drill many times: the share of attempts that succeed");
    run_->add_option("drill", drill_, "name or file of the drill (sim/drills/README.md)")->required();
    run_->add_option("strategy", trials_.strategy, "behaviour that practises, instead of the drill's");
    run_->add_option("--against", trials_.against, "behaviour of the opponents, instead of the drill's");
    run_->add_option("--trials", trials_.trials, "number of attempts, each with its own start")
        ->check(CLI::Range(1, 10'000'000))
        ->capture_default_str();
    run_->add_option("--seed", trials_.seed, "seed of the first attempt; the others have the next ones")
        ->check(CLI::Range(std::uint64_t{0}, kMostSeed))
        ->capture_default_str();
    run_->add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    if (list_->parsed()) return list();
    return show_->parsed() ? show() : play();
  }

 private:
  int list() const {
    io::Json names = io::Json::array();
    std::string text;
    for (const std::string_view name : io::names_of("drills")) {
      const auto drill = drills::load_drill(std::string(name));
      if (!drill) return fail(drill.error());
      names.push_back({{"name", name}, {"about", drill->about}});
      char line[400];
      std::snprintf(line, sizeof line, "%-32s%s\n", drill->name.c_str(), drill->about.c_str());
      text += line;
    }
    std::fputs(json_ ? (names.dump(2) + "\n").c_str() : text.c_str(), stdout);
    return kDone;
  }

  int show() const {
    const auto source = io::find_source("drills", "drill", drill_);
    if (!source) return fail(source.error());
    std::fputs(source->text.c_str(), stdout);
    return kDone;
  }

  int play() const {
    const auto drill = drills::load_drill(drill_);
    if (!drill) return fail(drill.error());
    const auto result = [&] {
      ProgressBar progress("practising " + drill_, static_cast<std::uint64_t>(trials_.trials));
      return drills::run_trials(*drill, trials_, [&](int done) { progress.at(static_cast<std::uint64_t>(done)); });
    }();
    if (!result) return fail(result.error());
    json_ ? print_json(*result) : print(*drill, *result);
    return kDone;
  }

  void print(const drills::Drill& drill, const drills::Trials& trials) const {
    std::printf("%s: %s\n\n", drill_.c_str(), drill.about.c_str());
    std::printf("success     %.1f %%  (95 %%: %.1f .. %.1f)   %d of %d attempts\n", 100 * trials.share(),
                100 * trials.interval.low, 100 * trials.interval.high, trials.succeeded, trials.trials);
    std::printf("ended by    success %d, failure %d, time %d\n", trials.successes, trials.failures, trials.times_over);
    if (trials.succeeded > 0) std::printf("after       %.1f ± %.1f s\n", trials.seconds.mean, trials.seconds.error);
    std::printf("score       %.3f ± %.3f\n", trials.score.mean, trials.score.error);
  }

  void print_json(const drills::Trials& trials) const {
    const io::Json json = {
        {"drill", drill_},
        {"trials", trials.trials},
        {"succeeded", trials.succeeded},
        {"success", trials.share()},
        {"low", trials.interval.low},
        {"high", trials.interval.high},
        {"ended", {{"success", trials.successes}, {"failure", trials.failures}, {"time", trials.times_over}}},
        {"score", {{"mean", trials.score.mean}, {"standard_error", trials.score.error}}},
        {"seconds", {{"mean", trials.seconds.mean}, {"standard_error", trials.seconds.error}}}};
    std::printf("%s\n", json.dump(2).c_str());
  }

  CLI::App *list_ = nullptr, *show_ = nullptr, *run_ = nullptr;  // owned by the program's CLI::App
  std::string drill_;
  drills::TrialOptions trials_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> drills_command(CLI::App& app) { return std::make_unique<DrillsCommand>(app); }

}  // namespace sim::app
