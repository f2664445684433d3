#include "sim/foresight/race.h"

#include <algorithm>

#include "sim/match/play.h"

namespace sim::foresight {
namespace {

constexpr Tick kLook = 64;        // [ticks] from one look at the budget to the next: 0.2 ms
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
      while (statistics_.spent < until)
        if (!play_stripe()) return;
      if (statistics_.stripes >= kFewestStripes) leave_behind();
    }
  }

 private:
  /// Returns the latest end of a rollout. Halves and games end by themselves.
  static Tick end_of(const Task& task) {
    const Question& question = task.question;
    const bool limited = question.until == Until::horizon || question.until == Until::next_goal;
    if (!limited || question.horizon == kNever) return kNever;
    return task.situation->state.world.tick + question.horizon;
  }

  /// Plays one stripe. Returns false when the budget is spent: the stripe does not count.
  bool play_stripe() {
    const RandomKey key{task_.key.seed + static_cast<std::uint64_t>(statistics_.stripes)};
    const State start = sample(*task_.params[0], *task_.situation, key);
    Outcome outcomes[kMaxStrategies];
    for (int i = 0; i < task_.strategies; ++i) {
      if (!statistics_.by_strategy[i].racing) continue;
      if (look() >= 1 || !play(start, *task_.params[i], statistics_.by_strategy[i], outcomes[i])) return false;
      ++rollouts_;
    }
    for (int i = 0; i < task_.strategies; ++i)
      if (statistics_.by_strategy[i].racing) enter(i, outcomes);
    ++statistics_.stripes;
    look();
    if (told_) told_(statistics_);
    return true;
  }

  double look() { return statistics_.spent = spent_(rollouts_); }

  /// Plays one rollout. Returns false when the budget ended before it.
  bool play(const State& start, const Params& params, StrategyStatistics& strategy, Outcome& outcome) {
    const Question& question = task_.question;
    const Tick began = start.world.tick;
    const bool is_path = statistics_.stripes < StrategyStatistics::kPaths;
    Path& path = strategy.paths[std::min(statistics_.stripes, StrategyStatistics::kPaths - 1)];
    const Tick length = std::min(end_ == kNever ? kLongestPath : end_ - began, kLongestPath);
    const Tick spacing = std::max<Tick>(length / (Path::kPoints - 1), 1);
    if (is_path) path = {.spacing = static_cast<float>(spacing) * kTickDuration};

    State state = start;
    bool cut = false;
    sim::play(
        params, state,
        [&](const State& now) {
          const Tick since = now.world.tick - began;
          if (since % kHeat == 0) add(strategy.heat, params.rules.field, unturned(now, start, now.world.ball.position));
          if (is_path && since % spacing == 0) add(path, now, start, question.own);
          if (since % kLook == kLook - 1 && look() >= 1) return cut = true;
          return is_over(now, start, outcome);
        },
        [&](const referee::Event& event) {
          if (event.kind != referee::Event::Kind::goal || outcome.next != 0) return;
          outcome.next = event.side == question.own ? 1 : -1;
        });
    statistics_.ticks += state.world.tick - began;
    if (!cut) outcome.value = value_of(params, start, state, outcome);
    return !cut;
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
  std::int64_t rollouts_ = 0;
};

}  // namespace

void race(const Task& task, const Spent& spent, const Told& told, RolloutStatistics& statistics) {
  Runner(task, spent, told, statistics).run();
}

}  // namespace sim::foresight
