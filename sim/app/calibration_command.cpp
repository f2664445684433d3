// foresight-sim calibration: do forecasts come true as often as they say? One robot asks in the middle of whole games,
// from its beliefs. The forecast is compared with the rest of the game.
#include <cmath>
#include <cstdio>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/progress.h"
#include "sim/contest/moments.h"
#include "sim/contest/series.h"
#include "sim/foresight/race.h"
#include "sim/foresight/reliability.h"
#include "sim/io/playbook.h"
#include "sim/match/play.h"
#include "sim/report/game_report.h"

namespace sim::app {
namespace {

using foresight::Reliability;

constexpr int kAsked = 1;              // home 2, usually the captain
constexpr int kSituationsPerGame = 8;  // situations
constexpr std::uint64_t kFirstCalibrationSeed = 2'000'001;

/// A forecast of an event, and whether the event came.
struct Case {
  double foretold = 0;  // [0..1]
  bool came = false;
};

struct Cases {
  std::vector<Case> score, concede;
  int untold = 0;  // situations without a forecast

  void add(const Cases& other) {
    score.insert(score.end(), other.score.begin(), other.score.end());
    concede.insert(concede.end(), other.concede.begin(), other.concede.end());
    untold += other.untold;
  }
};

Reliability reliability_of(const std::vector<Case>& cases) {
  Reliability reliability;
  for (const Case& one : cases) reliability.add(one.foretold, one.came);
  return reliability;
}

report::Json json_of(const Reliability& reliability) {
  report::Json bins = report::Json::array();
  for (const Reliability::Bin& bin : reliability.bins)
    if (bin.cases > 0)
      bins.push_back({{"cases", bin.cases},
                      {"foretold", bin.foretold / bin.cases},
                      {"came", static_cast<double>(bin.came) / bin.cases}});
  return {{"brier", reliability.brier()},
          {"base_rate", reliability.rate()},
          {"base_rate_brier", reliability.brier_of_rate()},
          {"deciles", std::move(bins)}};
}

void print(const char* what, const Reliability& reliability) {
  std::printf("%s: Brier score %.4f, of the base rate %.1f %%: %.4f\n", what, reliability.brier(),
              100 * reliability.rate(), reliability.brier_of_rate());
  for (const Reliability::Bin& bin : reliability.bins)
    if (bin.cases > 0)
      std::printf("  foretold %5.1f %%  came %5.1f ± %4.1f %%  %6d cases\n", 100 * bin.foretold / bin.cases,
                  100. * bin.came / bin.cases,
                  100 * std::sqrt(static_cast<double>(bin.came) * (bin.cases - bin.came) / bin.cases) / bin.cases,
                  bin.cases);
}

class CalibrationCommand final : public Command {
 public:
  explicit CalibrationCommand(CLI::App& app)
      : Command(app.add_subcommand("calibration", "do forecasts come true as often as they say?")) {
    choice_.add_to(options());
    options()
        .add_option("--situations", situations_, "number of situations")
        ->check(CLI::Range(kSituationsPerGame, 1'000'000))
        ->capture_default_str();
    options()
        .add_option("--rollouts", rollouts_, "number of futures per forecast")
        ->check(CLI::Range(foresight::kFewestStripes, 100'000))
        ->capture_default_str();
    options()
        .add_option("--seconds", seconds_, "[s] horizon of each forecast")
        ->check(CLI::Range(1., 300.))
        ->capture_default_str();
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    const io::Matchup choice = choice_.choice();
    const auto prepared = io::prepare(choice);
    if (!prepared) return fail(prepared.error());
    const auto playbook = choice_.playbook({choice.strategies[0]});
    if (!playbook) return fail(playbook.error());
    const int games = (situations_ + kSituationsPerGame - 1) / kSituationsPerGame;
    std::vector<Cases> by_game(static_cast<std::size_t>(games));
    {
      ProgressBar progress("foretelling", static_cast<std::uint64_t>(games));
      contest::for_each_game(
          games, contest::threads_for(games),
          [&](int game) {
            by_game[static_cast<std::size_t>(game)] =
                play(prepared->params, *playbook, kFirstCalibrationSeed + static_cast<std::uint64_t>(game));
          },
          [&](int done) { progress.at(static_cast<std::uint64_t>(done)); });
    }
    Cases all;
    for (const Cases& cases : by_game) all.add(cases);
    report(all);
    return kDone;
  }

 private:
  /// Plays a game. Returns the forecasts at its moments and the events that followed.
  Cases play(const Params& params, const io::Playbook& playbook, std::uint64_t seed) const {
    Cases cases;
    const Tick horizon = ticks(static_cast<float>(seconds_));
    contest::for_each_moment(params, seed, kSituationsPerGame, kAsked, [&](const State& state) {
      const foresight::Believed believed =
          foresight::believe(playbook.params.front(), foresight::knowledge_of(params, state, kAsked));
      if (!believed.refusal.empty()) {
        ++cases.untold;
        return;
      }
      foresight::RolloutStatistics tally;
      const foresight::Question question{.until = foresight::Until::next_goal, .horizon = horizon};
      foresight::race(
          io::task_of(playbook, {0}, believed.situation, question, {.seed = seed * 1'000'000 + state.world.tick}),
          [&](std::int64_t rollouts) { return static_cast<double>(rollouts) / rollouts_; }, {}, tally);

      State truth = state;
      int next = -1;
      sim::play(
          params, truth, [&](const State& now) { return next >= 0 || now.world.tick >= state.world.tick + horizon; },
          [&](const referee::Event& event) {
            if (event.kind == referee::Event::Kind::goal && next < 0) next = static_cast<int>(event.side);
          });
      const double futures = tally.by_strategy[0].rollouts;
      cases.score.push_back({tally.by_strategy[0].scored / futures, next == 0});
      cases.concede.push_back({tally.by_strategy[0].conceded / futures, next == 1});
    });
    return cases;
  }

  void report(const Cases& cases) const {
    const Reliability score = reliability_of(cases.score), concede = reliability_of(cases.concede);
    if (json_) {
      const report::Json json = {{"situations", cases.score.size()},
                                 {"untold", cases.untold},
                                 {"rollouts", rollouts_},
                                 {"seconds", seconds_},
                                 {"score", json_of(score)},
                                 {"concede", json_of(concede)}};
      std::printf("%s\n", json.dump(2).c_str());
      return;
    }
    std::printf("%zu situations, %d futures of %g s each; %d others had no forecast\n\n", cases.score.size(), rollouts_,
                seconds_, cases.untold);
    print("own goal next", score);
    print("goal of the others next", concede);
  }

  ChoiceOptions choice_;
  int situations_ = 1000, rollouts_ = 100;
  double seconds_ = 30;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> calibration_command(CLI::App& app) { return std::make_unique<CalibrationCommand>(app); }

}  // namespace sim::app
