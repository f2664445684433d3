// foresight-sim choosing: what is it worth to choose between strategies during a game?
//
// The first strategy plays games. At moments of these games each other strategy plays for a while, and then the first
// one again, in many futures of the true state. This measures two gains. One is that of the best strategy, for a
// captain that knows everything. The other is that of the strategy that a captain chooses by a few futures of its
// beliefs. Over a game such gains add up: the difference between two policies is the sum of the advantages of one over
// the other (Kakade and Langford, ICML 2002). Here the sum is over the first strategy's moments instead of the
// captain's own. So minutes are enough for a difference that whole games would show after days.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/progress.h"
#include "sim/contest/moments.h"
#include "sim/contest/series.h"
#include "sim/foresight/chooser.h"
#include "sim/foresight/forecast.h"
#include "sim/foresight/race.h"
#include "sim/io/playbook.h"
#include "sim/match/play.h"
#include "sim/report/game_report.h"

namespace sim::app {
namespace {

constexpr int kCaptain = 1;          // home 2
constexpr int kMomentsPerGame = 10;  // moments
constexpr Tick kAfter = ticks(30);   // goals still count this long after the return to the first strategy
constexpr std::uint64_t kFirstChoosingSeed = 3'000'001;

/// The knowledge of each captain.
constexpr struct {
  const char* name;
  foresight::Insight insight;
} kCaptains[] = {
    {"what it believes", {}},
    {"and the ball", {.ball = true}},
    {"and its own side", {.own_side = true}},
    {"and the opponents", {.opponents = true}},
    {"and all of them", {.ball = true, .own_side = true, .opponents = true}},
};

/// Goals gained over the first strategy, by strategy.
using Gains = std::vector<double>;

/// The gains in the futures of a moment, in two halves. The strategy that is best in one half is judged by the other
/// half.
struct Trial {
  Gains halves[2];
  Gains errors;             // one standard error of the mean of both halves
  std::vector<int> chosen;  // by each of kCaptains; 0 keeps the played strategy

  double gain(std::size_t strategy) const { return (halves[0][strategy] + halves[1][strategy]) / 2; }
  double of_knowing() const {
    double sum = 0;
    for (const int half : {0, 1}) {
      const auto best = std::max_element(halves[half].begin(), halves[half].end()) - halves[half].begin();
      sum += halves[1 - half][static_cast<std::size_t>(best)];
    }
    return sum / 2;
  }
};

/// Resets the leaves of all home robots for another tree. Also done for the first strategy, so that a copy of it gains
/// 0.
void begin_anew(State& state) {
  for (int player = 1; player <= state.world.players; ++player)
    state.robots[robot_of(Side::home, player)].mind.leaf = agent::kNoLeaf;
}

int lead(const State& state) { return state.book.score[0] - state.book.score[1]; }

class ChoosingCommand final : public Command {
 public:
  explicit ChoosingCommand(CLI::App& app)
      : Command(app.add_subcommand("choosing", "what is it worth to choose between strategies during a game?")) {
    choice_.add_to(options());
    options()
        .add_option("--strategies", strategies_, "2 .. 8 strategies of the home side, which plays the first")
        ->delimiter(',')
        ->required();
    options()
        .add_option("--moments", moments_, "number of moments at which strategies are compared")
        ->check(CLI::Range(kMomentsPerGame, 1'000'000))
        ->capture_default_str();
    options()
        .add_option("--futures", futures_, "number per strategy and moment, to find the truly best strategy")
        ->check(CLI::Range(4, 100'000))
        ->capture_default_str();
    options()
        .add_option("--period", period_, "[s] time between two choices, for which the chosen strategy is played")
        ->check(CLI::Range(1., 600.))
        ->capture_default_str();
    options()
        .add_option("--rollouts", terms_.rollouts, "number of futures of a captain's answer, all strategies together")
        ->check(CLI::Range(8, 100'000))
        ->capture_default_str();
    options()
        .add_option("--horizon", terms_.horizon, "[s] length of these futures")
        ->check(CLI::Range(1., 1200.))
        ->capture_default_str();
    options()
        .add_option("--sure", terms_.sure, "required probability that the gain of a change exceeds its cost")
        ->check(CLI::Range(0.5, 0.999))
        ->capture_default_str();
    options()
        .add_option("--switching-cost", terms_.switching_cost, "[goals] cost of a change")
        ->check(CLI::Range(0., 1.))
        ->capture_default_str();
    options().add_flag(
        "--insights", insights_,
        "also report captains that know the true places of the ball, of their own side or of the opponents");
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    if (strategies_.size() < 2) return fail("--strategies: expected at least two, got " + strategies_.front());
    const auto playbook = choice_.playbook(strategies_);
    if (!playbook) return fail(playbook.error());
    futures_ += futures_ % 2;  // they are halved
    const int games = (moments_ + kMomentsPerGame - 1) / kMomentsPerGame;
    std::vector<std::vector<Trial>> by_game(static_cast<std::size_t>(games));
    {
      ProgressBar progress("choosing", static_cast<std::uint64_t>(games));
      contest::for_each_game(
          games, contest::threads_for(games),
          [&](int game_number) {
            const std::uint64_t seed = kFirstChoosingSeed + static_cast<std::uint64_t>(game_number);
            std::vector<Trial>& trials = by_game[static_cast<std::size_t>(game_number)];
            contest::for_each_moment(playbook->params.front(), seed, kMomentsPerGame, kCaptain,
                                     [&](const State& state) { trials.push_back(look_at(*playbook, state, seed)); });
          },
          [&](int done) { progress.at(static_cast<std::uint64_t>(done)); });
    }
    std::vector<Trial> all;
    for (const std::vector<Trial>& trials : by_game) all.insert(all.end(), trials.begin(), trials.end());
    report(all, playbook->params.front().rules);
    return kDone;
  }

 private:
  Trial look_at(const io::Playbook& playbook, const State& state, std::uint64_t seed) const {
    const RandomKey key{seed * 1'000'000 + state.world.tick};
    Trial trial = futures_of(playbook, state, key);
    // another seed: a captain that saw the futures by which it is judged would look too good
    for (int i = 0; i < captains(); ++i)
      trial.chosen.push_back(choice_of(playbook, state, kCaptains[i].insight, {~key.seed}));
    return trial;
  }

  /// Plays each strategy on from the true state.
  Trial futures_of(const io::Playbook& playbook, const State& state, RandomKey key) const {
    const std::size_t count = playbook.params.size();
    Trial trial{.halves = {Gains(count), Gains(count)}, .errors = Gains(count)};
    std::vector<double> squares(count);
    const int each = futures_ / 2;
    std::vector<int> leads_of_first;
    for (std::size_t strategy = 0; strategy < count; ++strategy) {
      std::vector<State> futures(2 * static_cast<std::size_t>(each), state);
      for (std::size_t future = 0; future < futures.size(); ++future) futures[future].world.key = {key.seed + future};
      std::ranges::for_each(futures, begin_anew);
      play_on(playbook.params[strategy], futures, ticks(static_cast<float>(period_)));
      std::ranges::for_each(futures, begin_anew);
      play_on(playbook.params.front(), futures, kAfter);
      if (strategy == 0) std::ranges::transform(futures, std::back_inserter(leads_of_first), lead);
      for (std::size_t future = 0; future < futures.size(); ++future) {
        const double gain = lead(futures[future]) - leads_of_first[future];
        trial.halves[future % 2][strategy] += gain / each;
        squares[strategy] += gain * gain;
      }
    }
    for (std::size_t strategy = 0; strategy < count; ++strategy) {
      const double n = 2 * each, mean = trial.gain(strategy);
      trial.errors[strategy] = std::sqrt(std::max(squares[strategy] / n - mean * mean, 0.) / (n - 1));
    }
    return trial;
  }

  int captains() const { return insights_ ? static_cast<int>(std::size(kCaptains)) : 1; }

  /// Returns the captain's choice by its beliefs and its insight, or 0 when it has no forecast.
  int choice_of(const io::Playbook& playbook, const State& state, foresight::Insight insight, RandomKey key) const {
    const Params& params = playbook.params.front();
    foresight::Believed believed = foresight::believe(params, foresight::knowledge_of(params, state, kCaptain));
    if (!believed.refusal.empty()) return 0;
    foresight::tell(state.world, side_of(kCaptain), insight, believed.situation);
    const foresight::Question question{
        .horizon = ticks(terms_.horizon), .switching_cost = terms_.switching_cost, .sure = terms_.sure};
    foresight::RolloutStatistics tally;
    foresight::race(
        io::task_of(playbook, believed.situation, question, key),
        [&](std::int64_t rollouts) { return static_cast<double>(rollouts) / terms_.rollouts; }, {}, tally);
    return foresight::forecast(tally, question, key).choice;
  }

  void report(const std::vector<Trial>& trials, const field::Rules& rules) const {
    const double per_game = static_cast<double>(rules.half_duration) * rules.halves / period_;
    const auto a_game = [&](const auto& gain_of) {
      std::vector<double> gains;
      for (const Trial& trial : trials) gains.push_back(per_game * gain_of(trial));
      return contest::mean_of(gains);
    };
    const contest::Mean knowing = a_game([](const Trial& trial) { return trial.of_knowing(); });
    const auto told = [](const contest::Mean& mean) {
      return report::Json{{"mean", mean.mean}, {"standard_error", mean.error}};
    };
    report::Json captains_told = report::Json::array();
    for (int i = 0; i < captains(); ++i) {
      const auto chosen = [i](const Trial& trial) { return trial.chosen[static_cast<std::size_t>(i)]; };
      const auto changes =
          std::count_if(trials.begin(), trials.end(), [&](const Trial& trial) { return chosen(trial) != 0; });
      captains_told.push_back(
          {{"knows", kCaptains[i].name},
           {"gain",
            told(a_game([&](const Trial& trial) { return trial.gain(static_cast<std::size_t>(chosen(trial))); }))},
           {"changes", trials.empty() ? 0 : static_cast<double>(changes) / static_cast<double>(trials.size())}});
    }
    report::Json strategies = report::Json::array();
    for (std::size_t strategy = 1; strategy < strategies_.size(); ++strategy) {
      const contest::Mean mean = a_game([&](const Trial& trial) { return trial.gain(strategy); });
      strategies.push_back(
          {{"strategy", strategies_[strategy]}, {"always", told(mean)}, {"spread", spread_of(trials, strategy)}});
    }
    if (json_) {
      const report::Json json = {{"moments", trials.size()},    {"futures", futures_},       {"period", period_},
                                 {"rollouts", terms_.rollouts}, {"horizon", terms_.horizon}, {"strategies", strategies},
                                 {"knowing", told(knowing)},    {"captains", captains_told}};
      std::printf("%s\n", json.dump(2).c_str());
      return;
    }
    std::printf("%zu moments of games of %s against %s; %d futures of each strategy\n\n", trials.size(),
                strategies_.front().c_str(), choice_.choice().strategies[1].c_str(), futures_);
    std::printf("%-20s%26s%32s\n", "", "always, goals a game", "differs from moment to moment");
    for (const report::Json& one : strategies)
      std::printf("%-20s%+16.2f ± %-7.2f%24.3f goals\n", one["strategy"].get<std::string>().c_str(),
                  one["always"]["mean"].get<double>(), one["always"]["standard_error"].get<double>(),
                  one["spread"].get<double>());
    std::printf("\nthe best of them, chosen every %g s, gains in goals a game\n", period_);
    std::printf("  who knows the futures    %+.2f ± %.2f\n", knowing.mean, knowing.error);
    std::printf("  a captain, by %d futures of %g s of\n", terms_.rollouts, static_cast<double>(terms_.horizon));
    for (const report::Json& captain : captains_told)
      std::printf("    %-22s %+.2f ± %.2f, it changes in %.0f %%\n", captain["knows"].get<std::string>().c_str(),
                  captain["gain"]["mean"].get<double>(), captain["gain"]["standard_error"].get<double>(),
                  100 * captain["changes"].get<double>());
  }

  /// Returns the standard deviation of a strategy's true gains [goals], without the part of chance.
  static double spread_of(const std::vector<Trial>& trials, std::size_t strategy) {
    if (trials.empty()) return 0;
    double sum = 0, squares = 0, chance = 0;
    for (const Trial& trial : trials) {
      sum += trial.gain(strategy);
      squares += trial.gain(strategy) * trial.gain(strategy);
      chance += trial.errors[strategy] * trial.errors[strategy];
    }
    const auto count = static_cast<double>(trials.size());
    return std::sqrt(std::max((squares - chance) / count - sum * sum / count / count, 0.));
  }

  ChoiceOptions choice_;
  std::vector<std::string> strategies_;
  foresight::Terms terms_;
  int moments_ = 200, futures_ = 200;
  double period_ = 10;
  bool insights_ = false, json_ = false;
};

}  // namespace

std::unique_ptr<Command> choosing_command(CLI::App& app) { return std::make_unique<ChoosingCommand>(app); }

}  // namespace sim::app
