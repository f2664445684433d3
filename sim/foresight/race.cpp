#include "sim/foresight/race.h"

#include <algorithm>

#include "sim/match/play.h"

namespace sim::foresight {
namespace {

// Stripes that are played side by side: more would fill the lanes little better (sim/math/lanes.h).
constexpr int kStripes = 16;
constexpr Tick kLook = 64;        // [ticks] of all rollouts, from one look at the budget to the next: 0.2 ms
constexpr Tick kHeat = ticks(1);  // from one look at the ball to the next
constexpr Tick kLongestPath = ticks(120);

int index_of(Side side) { return static_cast<int>(side); }

/// Returns a point of `now` in the field of `start` [m], also after half time.
Vec2 unturned(const State& now, const State& start, Vec2 point) {
  return now.world.home_attacks == start.world.home_attacks ? point : -point;
}

void add(HeatMap& heat, const field::Field& field, Vec2 ball) {
  const auto cell = [](float place, float size, int cells) {
    const float share = std::clamp(place / size + 0.5f, 0.f, 1.f);
    return std::min(static_cast<int>(share * static_cast<float>(cells)), cells - 1);
  };
  ++heat.counts[cell(ball.y, field.width, HeatMap::kRows)][cell(ball.x, field.length, HeatMap::kColumns)];
}

void add(Path& path, const State& now, const State& start, Side own) {
  if (path.points == Path::kPoints) return;
  path.ball[path.points] = unturned(now, start, now.world.ball.position);
  for (int player = 1; player <= now.world.players; ++player)
    path.robots[path.points][player - 1] = unturned(now, start, now.world.bodies[robot_of(own, player)].position);
  ++path.points;
}

/// The result of one rollout.
struct Outcome {
  double value = 0;  // by the measure
  int next = 0;      // next goal: 1 own, -1 the opponents', 0 none
};

/// One run of all strategies over the stripes.
class Runner {
 public:
  Runner(const Task& task, const Spent& spent, const Told& told, RolloutStatistics& statistics)
      : task_(task), spent_(spent), told_(told), statistics_(statistics), end_(end_of(task)) {}

  void run() {
    statistics_ = {};
    statistics_.strategies = task_.strategies;
    int rounds = 1;
    while (1 << rounds < task_.strategies) ++rounds;
    for (int round = 1; round <= rounds; ++round) {
      const double until = static_cast<double>(round) / rounds;
      // the end of the budget cuts off what is played then: the nearer it is, the fewer stripes at once
      const double share = round == rounds ? 0.5 : 1;
      while (statistics_.spent < until)
        if (!play_stripes(affordable(share * (until - statistics_.spent)))) return;
      if (statistics_.stripes >= kFewestStripes) leave_behind();
    }
  }

 private:
  /// One strategy's rollout in one stripe.
  struct Rollout {
    State state;
    Runner* runner;
    const State* start;
    StrategyStatistics* strategy;
    Path* path;  // nullptr: it is not kept
    Outcome* outcome;

    bool goes_on() { return runner->goes_on(*this); }
    void see(const referee::Events& events) const {
      for (const referee::Event& event : events)
        if (event.kind == referee::Event::Kind::goal && outcome->next == 0)
          outcome->next = event.side == runner->task_.question.own ? 1 : -1;
    }
  };

  /// Returns the latest end of a rollout. Halves and games end by themselves.
  static Tick end_of(const Task& task) {
    const Question& question = task.question;
    const bool limited = question.until == Until::horizon || question.until == Until::next_goal;
    if (!limited || question.horizon == kNever) return kNever;
    return task.situation->state.world.tick + question.horizon;
  }

  /// Returns how many stripes a share of the budget allows, by the cost of the rollouts so far: 1 .. kStripes.
  int affordable(double share) const {
    if (rollouts_ == 0) return 1;
    int racing = 0;
    for (int i = 0; i < task_.strategies; ++i) racing += statistics_.by_strategy[i].racing ? 1 : 0;
    const double cost = statistics_.spent * racing / static_cast<double>(rollouts_);
    return static_cast<int>(std::clamp(share / cost, 1., static_cast<double>(kStripes)));
  }

  /// Plays stripes side by side. Returns false when the budget is spent: these stripes do not count.
  bool play_stripes(int count) {
    for (int stripe = 0; stripe < count; ++stripe)
      starts_[stripe] = sample(*task_.params[0], *task_.situation,
                               {task_.key.seed + static_cast<std::uint64_t>(statistics_.stripes + stripe)});
    for (int i = 0; i < task_.strategies; ++i) {
      if (!statistics_.by_strategy[i].racing) continue;
      if (look() >= 1 || !play(i, count)) return false;
      rollouts_ += count;
    }
    for (int stripe = 0; stripe < count; ++stripe) {
      for (int i = 0; i < task_.strategies; ++i)
        if (statistics_.by_strategy[i].racing) enter(i, outcomes_[stripe]);
      ++statistics_.stripes;
      look();
      if (told_) told_(statistics_);
    }
    return true;
  }

  double look() { return statistics_.spent = spent_(rollouts_); }

  /// Plays one strategy in stripes. Returns false when the budget ended before they did.
  bool play(int strategy, int count) {
    StrategyStatistics& statistics = statistics_.by_strategy[strategy];
    const Params& params = *task_.params[strategy];
    int begun = 0;
    play_many<Rollout>(params, static_cast<std::size_t>(count), [&](const Rollout*) -> Rollout* {
      if (begun == count) return nullptr;
      const int stripe = begun++, number = statistics_.stripes + stripe;
      Path* const path = number < StrategyStatistics::kPaths ? &statistics.paths[number] : nullptr;
      if (path) *path = {.spacing = static_cast<float>(spacing()) * kTickDuration};
      outcomes_[stripe][strategy] = {};
      played_[stripe] = {starts_[stripe], this, &starts_[stripe], &statistics, path, &outcomes_[stripe][strategy]};
      return &played_[stripe];
    });
    for (int stripe = 0; stripe < count; ++stripe) {
      const State &start = starts_[stripe], &end = played_[stripe].state;
      statistics_.ticks += end.world.tick - start.world.tick;
      outcomes_[stripe][strategy].value = value_of(params, start, end, outcomes_[stripe][strategy]);
    }
    return !cut_;
  }

  /// Returns the time from one point of a path to the next [ticks].
  Tick spacing() const {
    const Tick began = task_.situation->state.world.tick;
    const Tick length = std::min(end_ == kNever ? kLongestPath : end_ - began, kLongestPath);
    return std::max<Tick>(length / (Path::kPoints - 1), 1);
  }

  /// Notes where a rollout is. Reports whether it goes on.
  bool goes_on(Rollout& rollout) {
    const State &now = rollout.state, &start = *rollout.start;
    const Tick since = now.world.tick - start.world.tick;
    if (since % kHeat == 0)
      add(rollout.strategy->heat, task_.params[0]->rules.field, unturned(now, start, now.world.ball.position));
    if (rollout.path && since % spacing() == 0) add(*rollout.path, now, start, task_.question.own);
    if (++ticks_ % kLook == 0 && look() >= 1) cut_ = true;
    return !cut_ && !is_over(now, start, *rollout.outcome);
  }

  bool is_over(const State& now, const State& start, const Outcome& outcome) const {
    if (now.world.tick >= end_) return true;
    // these measures need only the next goal
    if (outcome.next != 0 && (task_.question.until == Until::next_goal || !counts_goals())) return true;
    return task_.question.until == Until::half && now.book.half != start.book.half;
  }

  bool counts_goals() const { return task_.question.measure == Measure::goal_difference; }

  double value_of(const Params& params, const State& start, const State& state, const Outcome& outcome) const {
    if (task_.question.measure == Measure::score_next) return outcome.next > 0 ? 1 : 0;
    if (task_.question.measure == Measure::concede) return outcome.next < 0 ? -1 : 0;
    const int own = index_of(task_.question.own), others = 1 - own;
    const int scored = state.book.score[own] - start.book.score[own];
    const int conceded = state.book.score[others] - start.book.score[others];
    double value = scored - conceded;
    if (task_.question.until == Until::horizon && task_.outlook && !finished(state))
      value += static_cast<double>(worth(*task_.outlook, params, state, task_.question.own));
    return value;
  }

  void enter(int i, const Outcome (&outcomes)[kMaxStrategies]) {
    StrategyStatistics& strategy = statistics_.by_strategy[i];
    const Outcome& outcome = outcomes[i];
    ++strategy.rollouts;
    strategy.sum += outcome.value;
    strategy.squares += outcome.value * outcome.value;
    strategy.scored += outcome.next > 0 ? 1 : 0;
    strategy.conceded += outcome.next < 0 ? 1 : 0;
    for (int j = 0; j < task_.strategies; ++j) {
      if (!statistics_.by_strategy[j].racing) continue;
      const double gain = outcome.value - outcomes[0].value;
      statistics_.gains[i][j] += gain;
      statistics_.products[i][j] += gain * (outcomes[j].value - outcomes[0].value);
    }
  }

  /// Drops the worse half of the racing strategies, but never the incumbent and never its last challenger. All have
  /// played the same stripes, so that the better sum is the better mean.
  void leave_behind() {
    int racing = 0;
    for (int i = 0; i < task_.strategies; ++i) racing += statistics_.by_strategy[i].racing ? 1 : 0;
    for (int rest = std::max((racing + 1) / 2, 2); racing > rest; --racing) {
      int worst = 0;
      for (int i = 1; i < task_.strategies; ++i) {
        if (!statistics_.by_strategy[i].racing) continue;
        if (worst == 0 || statistics_.by_strategy[i].sum < statistics_.by_strategy[worst].sum) worst = i;
      }
      statistics_.by_strategy[worst].racing = false;
    }
  }

  const Task& task_;
  const Spent& spent_;
  const Told& told_;
  RolloutStatistics& statistics_;
  const Tick end_;
  std::int64_t rollouts_ = 0;  // played to their ends
  std::int64_t ticks_ = 0;     // of all rollouts
  bool cut_ = false;           // the budget ended within a rollout
  State starts_[kStripes];     // by stripe
  Rollout played_[kStripes];
  Outcome outcomes_[kStripes][kMaxStrategies];
};

}  // namespace

void race(const Task& task, const Spent& spent, const Told& told, RolloutStatistics& statistics) {
  Runner(task, spent, told, statistics).run();
}

}  // namespace sim::foresight
