#include "sim/drills/trials.h"

#include <memory>
#include <vector>

#include "sim/contest/lineup_series.h"
#include "sim/match/play.h"

namespace sim::drills {
namespace {

/// An attempt that is being played. It stays where it is: the judge refers to the start.
class Practice {
 public:
  State state;
  const std::size_t number;

  Practice(const Drill& drill, const State& start, std::size_t its_number)
      : state(start), number(its_number), start_(start), judge_(drill, start_) {}

  bool goes_on() const { return outcome_ == Outcome::running; }
  void see(const referee::Events& events) { outcome_ = judge_.see(state, events); }
  Ended ended() const {
    return {outcome_, judge_.succeeded(outcome_), judge_.score(), age(state.world.tick, start_.world.tick)};
  }

 private:
  const State start_;
  Attempt judge_;
  Outcome outcome_ = Outcome::running;
};

Trials counted(const std::vector<Ended>& all) {
  Trials trials{.trials = static_cast<int>(all.size())};
  std::vector<double> scores, seconds;
  for (const Ended& one : all) {
    trials.successes += one.outcome == Outcome::success;
    trials.failures += one.outcome == Outcome::failure;
    trials.times_over += one.outcome == Outcome::time_over;
    trials.succeeded += one.succeeded;
    scores.push_back(static_cast<double>(one.score));
    if (one.succeeded) seconds.push_back(static_cast<double>(one.seconds));
  }
  trials.interval = check::interval_of_share(trials.succeeded, trials.trials);
  trials.score = contest::mean_of(scores);
  trials.seconds = contest::mean_of(seconds);
  return trials;
}

}  // namespace

void play_attempts(const Drill& drill, const Starts& starts, const Params& params, std::uint64_t first_seed,
                   std::span<Ended> ended) {
  std::vector<std::unique_ptr<Practice>> playing(ended.size());
  std::size_t begun = 0;
  play_many<Practice>(params, kTogether, [&](const Practice* before) -> Practice* {
    if (before) {
      ended[before->number] = before->ended();
      playing[before->number].reset();
    }
    if (begun == ended.size()) return nullptr;
    const std::size_t number = begun++;
    playing[number] = std::make_unique<Practice>(drill, starts.draw(params, {first_seed + number}), number);
    return playing[number].get();
  });
}

robot::Result<Trials> run_trials(const Drill& drill, const TrialOptions& options,
                                 const std::function<void(int)>& progress) {
  contest::LineupChoice choice{.game = drill.game, .rest = {}};
  if (!options.strategy.empty()) choice.game.strategies[0] = options.strategy;
  if (!options.against.empty()) choice.game.strategies[1] = options.against;
  const auto lineup = contest::Lineup::prepare(choice);
  if (!lineup) return lineup.failure();
  const auto starts = Starts::prepare(drill, lineup->params());
  if (!starts) return starts.failure();

  std::vector<Ended> all(static_cast<std::size_t>(options.trials));
  const auto played = contest::play_series(
      *lineup, {.first_seed = options.seed, .games = options.trials},
      [&](int trial, std::uint64_t seed, const contest::Cast& cast) {
        return std::make_unique<Practice>(drill, starts->draw(cast.params(), {seed}), static_cast<std::size_t>(trial));
      },
      [&](int trial, const Practice& practice, const contest::Cast&) {
        all[static_cast<std::size_t>(trial)] = practice.ended();
      },
      progress);
  if (!played) return played.failure();
  return counted(all);
}

}  // namespace sim::drills
