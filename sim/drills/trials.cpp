#include "sim/drills/trials.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "sim/match/step.h"

namespace sim::drills {
namespace {

/// An attempt that is being played. It stays where it is: the judge refers to the start.
struct Practice {
  Practice(const Drill& drill, const State& from, std::size_t its_number)
      : start(from), state(from), judge(drill, start), number(its_number) {}

  State start, state;
  Attempt judge;
  std::size_t number;
};

Ended ended_of(const Practice& practice, Outcome outcome) {
  return {outcome, practice.judge.succeeded(outcome), practice.judge.score(),
          age(practice.state.world.tick, practice.start.world.tick)};
}

/// Plays one attempt with behaviours of its own.
Ended play(const Drill& drill, const Starts& starts, const contest::Cast& cast, std::uint64_t seed) {
  Practice practice(drill, starts.draw(cast.params(), {seed}), 0);
  referee::Events events;
  Outcome outcome = Outcome::running;
  while (outcome == Outcome::running && !cast.failed()) {
    step(cast.params(), practice.state, events);
    outcome = practice.judge.see(practice.state, events);
  }
  return ended_of(practice, outcome);
}

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

constexpr int kBlock = 4 * static_cast<int>(kTogether);  // attempts of one task

/// Plays all attempts of trees, in blocks.
void play_trees(const Drill& drill, const Starts& starts, const Params& params, std::uint64_t first_seed,
                std::span<Ended> ended, const std::function<void(int)>& progress) {
  const int all = static_cast<int>(ended.size()), blocks = (all + kBlock - 1) / kBlock;
  contest::for_each_game(
      blocks, contest::threads_for(blocks),
      [&](int block) {
        const auto from = static_cast<std::size_t>(block) * kBlock;
        const std::size_t count = std::min<std::size_t>(kBlock, ended.size() - from);
        play_attempts(drill, starts, params, first_seed + from, ended.subspan(from, count));
      },
      [&](int finished) {
        if (progress) progress(std::min(all, finished * kBlock));
      });
}

}  // namespace

void play_attempts(const Drill& drill, const Starts& starts, const Params& params, std::uint64_t first_seed,
                   std::span<Ended> ended) {
  std::vector<std::unique_ptr<Practice>> playing;
  std::vector<State*> states;
  std::array<referee::Events, kTogether> events;
  std::size_t begun = 0;
  const auto next = [&] {
    const State start = starts.draw(params, {first_seed + begun});
    return std::make_unique<Practice>(drill, start, begun++);
  };
  while (playing.size() < kTogether && begun < ended.size()) playing.push_back(next());
  while (!playing.empty()) {
    states.clear();
    for (const auto& practice : playing) states.push_back(&practice->state);
    step_many(params, states, {events.data(), states.size()});
    for (std::size_t i = 0; i < playing.size(); ++i) {
      const Outcome outcome = playing[i]->judge.see(playing[i]->state, events[i]);
      if (outcome == Outcome::running) continue;
      ended[playing[i]->number] = ended_of(*playing[i], outcome);
      playing[i] = begun < ended.size() ? next() : nullptr;
    }
    std::erase(playing, nullptr);
  }
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
  if (!lineup->has_guest(Side::home) && !lineup->has_guest(Side::away)) {
    play_trees(drill, *starts, lineup->params(), options.seed, all, progress);
    return counted(all);
  }
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
