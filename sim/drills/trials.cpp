#include "sim/drills/trials.h"

#include <vector>

#include "sim/match/step.h"

namespace sim::drills {
namespace {

struct Ended {
  Outcome outcome = Outcome::running;
  bool succeeded = false;
  double score = 0;
  double seconds = 0;
};

Ended play(const Drill& drill, const Starts& starts, const contest::Cast& cast, std::uint64_t seed) {
  const State start = starts.draw(cast.params(), {seed});
  State state = start;
  Attempt attempt(drill, start);
  referee::Events events;
  Outcome outcome = Outcome::running;
  while (outcome == Outcome::running && !cast.failed()) {
    step(cast.params(), state, events);
    outcome = attempt.see(state, events);
  }
  return {outcome, attempt.succeeded(outcome), static_cast<double>(attempt.score()),
          static_cast<double>(age(state.world.tick, start.world.tick))};
}

Trials counted(const std::vector<Ended>& all) {
  Trials trials{.trials = static_cast<int>(all.size())};
  std::vector<double> scores, seconds;
  for (const Ended& one : all) {
    trials.successes += one.outcome == Outcome::success;
    trials.failures += one.outcome == Outcome::failure;
    trials.times_over += one.outcome == Outcome::time_over;
    trials.succeeded += one.succeeded;
    scores.push_back(one.score);
    if (one.succeeded) seconds.push_back(one.seconds);
  }
  trials.interval = check::interval_of_share(trials.succeeded, trials.trials);
  trials.score = contest::mean_of(scores);
  trials.seconds = contest::mean_of(seconds);
  return trials;
}

}  // namespace

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
  const auto played = contest::for_each_cast(
      *lineup, options.seed, options.trials, 0,
      [&](int trial, std::uint64_t seed, const contest::Cast& cast) {
        all[static_cast<std::size_t>(trial)] = play(drill, *starts, cast, seed);
      },
      progress);
  if (!played) return played.failure();
  return counted(all);
}

}  // namespace sim::drills
