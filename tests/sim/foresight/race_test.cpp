#include "sim/foresight/race.h"

#include <gtest/gtest.h>

#include <cstring>

#include "sim/io/playbook.h"
#include "sim/match/play.h"
#include "sim/match/situation.h"
#include "tests/sim/support/allocations.h"
#include "tests/sim/support/games.h"

namespace sim::foresight {
namespace {

using Strategies = std::vector<std::string>;

/// Strategies that play on from some situation.
struct RaceFixture {
  io::Playbook playbook;
  Situation situation;

  explicit RaceFixture(const Strategies& strategies, std::uint64_t seed = 5) {
    auto prepared = io::prepare_playbook({.strategies = strategies});
    if (!prepared) {
      ADD_FAILURE() << prepared.error();
      return;
    }
    playbook = std::move(*prepared);
    situation.state = random_situation(playbook.params.front(), {.seed = seed});
  }

  Task task(const Question& question = {.horizon = ticks(5)}) const {
    return io::task_of(playbook, situation, question, {.seed = 100});
  }
};

Spent rollouts(double budget) {
  return [budget](std::int64_t so_far) { return static_cast<double>(so_far) / budget; };
}

RolloutStatistics run(const Task& task, double budget) {
  RolloutStatistics statistics;
  race(task, rollouts(budget), {}, statistics);
  return statistics;
}

TEST(Race, TheSameBudgetGivesTheSameStatistics) {
  const RaceFixture fixture({"baseline", "kick_now", "passing"});
  const RolloutStatistics one = run(fixture.task(), 60), other = run(fixture.task(), 60);
  EXPECT_EQ(std::memcmp(&one.gains, &other.gains, sizeof one.gains), 0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(one.by_strategy[i].rollouts, other.by_strategy[i].rollouts);
    EXPECT_EQ(one.by_strategy[i].sum, other.by_strategy[i].sum);
  }
}

TEST(Race, AStripeIsTheFutureOfItsKeyThatIsPlayedAlone) {
  const RaceFixture fixture({"baseline", "kick_now"});
  const Task task = fixture.task({.until = Until::next_goal, .horizon = ticks(60)});
  const RolloutStatistics statistics = run(task, 100);
  ASSERT_EQ(statistics.stripes, 50);
  std::int64_t played = 0;
  for (const int i : {0, 1}) {
    int goals[2] = {0, 0};
    for (std::uint64_t stripe = 0; stripe < 50; ++stripe) {
      State state = sample(*task.params[0], *task.situation, {task.key.seed + stripe});
      const Tick end = state.world.tick + ticks(60);
      const auto scored = [&] { return goals[0] + goals[1]; };
      const int before = scored();
      played += play(
          *task.params[i], state, [&](const State& now) { return now.world.tick >= end || scored() > before; },
          [&](const referee::Event& event) {
            if (event.kind == referee::Event::Kind::goal) ++goals[static_cast<int>(event.side)];
          });
    }
    EXPECT_EQ(statistics.by_strategy[i].scored, goals[0]);
    EXPECT_EQ(statistics.by_strategy[i].conceded, goals[1]);
    EXPECT_GT(goals[0] + goals[1], 0);
  }
  EXPECT_EQ(statistics.ticks, played);
}

TEST(Race, AStrategyGainsNothingOverItself) {
  const RaceFixture fixture({"baseline", "baseline,keeper_radius=0.7"});
  const RolloutStatistics statistics = run(fixture.task({.until = Until::horizon, .horizon = ticks(20)}), 40);
  ASSERT_EQ(statistics.stripes, 20);
  EXPECT_EQ(statistics.gains[1][1], 0);
  EXPECT_EQ(statistics.products[1][1], 0);
  EXPECT_EQ(statistics.by_strategy[0].sum, statistics.by_strategy[1].sum);
}

TEST(Race, EachRolloutCountsAgainstTheBudget) {
  const RaceFixture fixture({"baseline", "kick_now", "passing", "align_first", "idle"});
  for (const double budget : {1., 7., 45., 200.}) {
    const RolloutStatistics statistics = run(fixture.task(), budget);
    int played = 0;
    for (int i = 0; i < statistics.strategies; ++i) played += statistics.by_strategy[i].rollouts;
    EXPECT_LE(played, budget);
    EXPECT_GT(played, budget - 5) << "only the last stripe may be cut";
  }
}

TEST(Race, TheWorseHalfIsDroppedButNeverTheIncumbent) {
  const RaceFixture fixture({"idle", "baseline", "kick_now", "passing", "align_first"});
  const RolloutStatistics statistics = run(fixture.task({.horizon = ticks(20)}), 300);
  EXPECT_TRUE(statistics.by_strategy[0].racing);
  int racing = 0;
  for (int i = 0; i < statistics.strategies; ++i) racing += statistics.by_strategy[i].racing ? 1 : 0;
  EXPECT_EQ(racing, 2);
  for (int i = 0; i < statistics.strategies; ++i) {
    EXPECT_EQ(statistics.by_strategy[i].racing, statistics.by_strategy[i].rollouts == statistics.stripes);
    for (int j = 0; j < statistics.strategies; ++j) EXPECT_EQ(statistics.products[i][j], statistics.products[j][i]);
  }
}

TEST(Race, AStripeThatIsCutDoesNotCount) {
  const RaceFixture fixture({"baseline", "kick_now"});
  // the budget ends within a rollout, after this many looks
  for (int looks = 1; looks < 40; looks += 3) {
    RolloutStatistics statistics, heard;
    int left = looks;
    race(
        fixture.task({.horizon = ticks(20)}), [&](std::int64_t) { return --left < 0 ? 1. : 0.; },
        [&](const RolloutStatistics& now) { heard = now; }, statistics);
    EXPECT_EQ(statistics.by_strategy[0].rollouts, statistics.stripes);
    EXPECT_EQ(statistics.by_strategy[1].rollouts, statistics.stripes);
    EXPECT_EQ(heard.stripes, statistics.stripes);
    EXPECT_EQ(heard.by_strategy[1].sum, statistics.by_strategy[1].sum);
  }
}

TEST(Race, ReportsAfterEachStripe) {
  const RaceFixture fixture({"baseline", "kick_now"});
  int told = 0;
  RolloutStatistics statistics;
  race(
      fixture.task(), rollouts(30), [&](const RolloutStatistics& now) { EXPECT_EQ(now.stripes, ++told); }, statistics);
  EXPECT_EQ(told, 15);
}

TEST(Race, AllocatesNothing) {
  const RaceFixture fixture({"baseline", "kick_now", "passing"});
  const Task task = fixture.task();
  const Spent spent = rollouts(30);
  const Told told = [](const RolloutStatistics&) {};
  RolloutStatistics statistics;
  const std::size_t before = test::allocations();
  race(task, spent, told, statistics);
  EXPECT_EQ(test::allocations(), before);
}

TEST(Race, MeasuresAgree) {
  // until the next goal, the goal difference is one goal scored less one conceded
  RaceFixture fixture({"baseline", "kick_now"});
  place(fixture.situation.state.world.ball, {2.6f, 0.2f});
  Question question{.until = Until::next_goal, .horizon = ticks(60)};
  const RolloutStatistics goals = run(fixture.task(question), 60);
  question.measure = Measure::score_next;
  const RolloutStatistics scored = run(fixture.task(question), 60);
  question.measure = Measure::concede;
  const RolloutStatistics conceded = run(fixture.task(question), 60);
  for (const int i : {0, 1}) {
    EXPECT_EQ(goals.by_strategy[i].sum, scored.by_strategy[i].sum + conceded.by_strategy[i].sum);
    EXPECT_EQ(scored.by_strategy[i].sum, scored.by_strategy[i].scored);
    EXPECT_EQ(conceded.by_strategy[i].sum, -conceded.by_strategy[i].conceded);
    EXPECT_GT(goals.by_strategy[i].scored + goals.by_strategy[i].conceded, 0);
  }
}

TEST(Race, LooksToTheRequestedHorizon) {
  const RaceFixture fixture({"baseline"});
  const RolloutStatistics five = run(fixture.task({.horizon = ticks(5)}), 10);
  EXPECT_EQ(five.ticks, 10 * ticks(5));

  RaceFixture late({"baseline"});
  late.situation.state.book.clock = ticks(late.playbook.params.front().rules.half_duration - 4);
  const RolloutStatistics half = run(late.task({.until = Until::half}), 10);
  EXPECT_EQ(half.ticks, 10 * ticks(4)) << "the rest of the half";
  late.situation.state.book.half = 2;
  const RolloutStatistics game = run(late.task({.until = Until::game}), 10);
  EXPECT_EQ(game.ticks, 10 * ticks(4)) << "the rest of the game";
}

TEST(Race, ALostGameDoesNotLookLikeAWonOne) {
  const RaceFixture fixture({"idle", "baseline"});
  const RolloutStatistics statistics = run(fixture.task({.horizon = ticks(60)}), 120);
  EXPECT_GT(statistics.gains[1][1], 0);
}

TEST(Race, TheAwaySideSeesItTheOtherWayRound) {
  const auto playbook = io::prepare_playbook({.strategies = {"baseline", "idle"}, .own = Side::away});
  ASSERT_TRUE(playbook);
  const Situation situation{.state = random_situation(playbook->params.front(), {.seed = 5}), .doubt = {}};
  const RolloutStatistics statistics =
      run(io::task_of(*playbook, {0, 1}, situation, {.horizon = ticks(60)}, {.seed = 100}), 120);
  EXPECT_LT(statistics.gains[1][1], 0);
}

TEST(Race, KeepsPathsAndTheBallsHeat) {
  const RaceFixture fixture({"baseline", "kick_now"});
  const RolloutStatistics statistics = run(fixture.task({.horizon = ticks(30)}), 20);
  for (const int i : {0, 1}) {
    for (const Path& path : statistics.by_strategy[i].paths) {
      EXPECT_EQ(path.points, Path::kPoints);
      EXPECT_FLOAT_EQ(path.spacing, 1);
      EXPECT_EQ(path.ball[0], fixture.situation.state.world.ball.position);
      EXPECT_EQ(path.robots[0][1], fixture.situation.state.world.bodies[1].position);
    }
    std::uint32_t all = 0;
    for (const auto& row : statistics.by_strategy[i].heat.counts)
      for (const std::uint32_t count : row) all += count;
    EXPECT_EQ(all, 10u * 31u) << "each second, the first and the last too";
  }
}

TEST(Race, HalfTimeDoesNotTurnPathsAndHeatRound) {
  RaceFixture fixture({"baseline"});
  State& state = fixture.situation.state;
  state.book.half = 1;
  state.book.clock = ticks(fixture.playbook.params.front().rules.half_duration - 4);
  const RolloutStatistics statistics = run(fixture.task({.until = Until::game}), 8);
  const Path& path = statistics.by_strategy[0].paths[0];
  ASSERT_EQ(path.points, Path::kPoints) << "two minutes, of which 4 s are of the first half";
  for (int point = 0; point < path.points; ++point)
    EXPECT_LE(path.robots[point][0].x, 0) << "the keeper at " << point << " stays in its half";
}

}  // namespace
}  // namespace sim::foresight
