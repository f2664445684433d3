#include "sim/foresight/race.h"

#include <gtest/gtest.h>

#include <cstring>

#include "sim/io/playbook.h"
#include "sim/match/situation.h"
#include "tests/sim/support/allocations.h"
#include "tests/sim/support/games.h"

namespace sim::foresight {
namespace {

using Strategies = std::vector<std::string>;

/// Strategies that play on from some situation.
struct Fixture {
  io::Playbook playbook;
  Situation situation;

  explicit Fixture(const Strategies& strategies, std::uint64_t seed = 5) {
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

Tally run(const Task& task, double budget) {
  Tally tally;
  race(task, rollouts(budget), {}, tally);
  return tally;
}

TEST(Race, TheSameBudgetIsTheSameTally) {
  const Fixture fixture({"baseline", "kick_now", "passing"});
  const Tally one = run(fixture.task(), 60), other = run(fixture.task(), 60);
  EXPECT_EQ(std::memcmp(&one.gains, &other.gains, sizeof one.gains), 0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(one.accounts[i].rollouts, other.accounts[i].rollouts);
    EXPECT_EQ(one.accounts[i].sum, other.accounts[i].sum);
  }
}

TEST(Race, AStrategyGainsNothingOverItself) {
  const Fixture fixture({"baseline", "baseline,keeper_radius=0.7"});
  const Tally tally = run(fixture.task({.until = Until::horizon, .horizon = ticks(20)}), 40);
  ASSERT_EQ(tally.stripes, 20);
  EXPECT_EQ(tally.gains[1][1], 0);
  EXPECT_EQ(tally.products[1][1], 0);
  EXPECT_EQ(tally.accounts[0].sum, tally.accounts[1].sum);
}

TEST(Race, EachRolloutIsPaidFor) {
  const Fixture fixture({"baseline", "kick_now", "passing", "align_first", "idle"});
  for (const double budget : {1., 7., 45., 200.}) {
    const Tally tally = run(fixture.task(), budget);
    int played = 0;
    for (int i = 0; i < tally.strategies; ++i) played += tally.accounts[i].rollouts;
    EXPECT_LE(played, budget);
    EXPECT_GT(played, budget - 5) << "only the last stripe may be cut";
  }
}

TEST(Race, TheWorseHalfIsLeftBehindAndTheIncumbentNever) {
  const Fixture fixture({"idle", "baseline", "kick_now", "passing", "align_first"});
  const Tally tally = run(fixture.task({.horizon = ticks(20)}), 300);
  EXPECT_TRUE(tally.accounts[0].racing);
  int racing = 0;
  for (int i = 0; i < tally.strategies; ++i) racing += tally.accounts[i].racing ? 1 : 0;
  EXPECT_EQ(racing, 2);
  for (int i = 0; i < tally.strategies; ++i) {
    EXPECT_EQ(tally.accounts[i].racing, tally.accounts[i].rollouts == tally.stripes);
    for (int j = 0; j < tally.strategies; ++j) EXPECT_EQ(tally.products[i][j], tally.products[j][i]);
  }
}

TEST(Race, AStripeThatIsCutDoesNotCount) {
  const Fixture fixture({"baseline", "kick_now"});
  // the budget ends in the middle of a rollout: after so many looks
  for (int looks = 1; looks < 40; looks += 3) {
    Tally tally, heard;
    int left = looks;
    race(
        fixture.task({.horizon = ticks(20)}), [&](std::int64_t) { return --left < 0 ? 1. : 0.; },
        [&](const Tally& now) { heard = now; }, tally);
    EXPECT_EQ(tally.accounts[0].rollouts, tally.stripes);
    EXPECT_EQ(tally.accounts[1].rollouts, tally.stripes);
    EXPECT_EQ(heard.stripes, tally.stripes);
    EXPECT_EQ(heard.accounts[1].sum, tally.accounts[1].sum);
  }
}

TEST(Race, TellsAfterEachStripe) {
  const Fixture fixture({"baseline", "kick_now"});
  int told = 0;
  Tally tally;
  race(
      fixture.task(), rollouts(30), [&](const Tally& now) { EXPECT_EQ(now.stripes, ++told); }, tally);
  EXPECT_EQ(told, 15);
}

TEST(Race, AllocatesNothing) {
  const Fixture fixture({"baseline", "kick_now", "passing"});
  const Task task = fixture.task();
  const Spent spent = rollouts(30);
  const Told told = [](const Tally&) {};
  Tally tally;
  const std::size_t before = test::allocations();
  race(task, spent, told, tally);
  EXPECT_EQ(test::allocations(), before);
}

TEST(Race, MeasuresAgree) {
  // until the next goal, the goal difference is one goal scored less one conceded
  Fixture fixture({"baseline", "kick_now"});
  place(fixture.situation.state.world.ball, {2.6f, 0.2f});
  Question question{.until = Until::next_goal, .horizon = ticks(60)};
  const Tally goals = run(fixture.task(question), 60);
  question.measure = Measure::score_next;
  const Tally scored = run(fixture.task(question), 60);
  question.measure = Measure::concede;
  const Tally conceded = run(fixture.task(question), 60);
  for (const int i : {0, 1}) {
    EXPECT_EQ(goals.accounts[i].sum, scored.accounts[i].sum + conceded.accounts[i].sum);
    EXPECT_EQ(scored.accounts[i].sum, scored.accounts[i].scored);
    EXPECT_EQ(conceded.accounts[i].sum, -conceded.accounts[i].conceded);
    EXPECT_GT(goals.accounts[i].scored + goals.accounts[i].conceded, 0);
  }
}

TEST(Race, LooksAsFarAsItIsAsked) {
  const Fixture fixture({"baseline"});
  const Tally five = run(fixture.task({.horizon = ticks(5)}), 10);
  EXPECT_EQ(five.ticks, 10 * ticks(5));

  Fixture late({"baseline"});
  late.situation.state.book.clock = ticks(late.playbook.params.front().rules.half_duration - 4);
  const Tally half = run(late.task({.until = Until::half}), 10);
  EXPECT_EQ(half.ticks, 10 * ticks(4)) << "the rest of the half";
  late.situation.state.book.half = 2;
  const Tally game = run(late.task({.until = Until::game}), 10);
  EXPECT_EQ(game.ticks, 10 * ticks(4)) << "the rest of the game";
}

TEST(Race, ALostGameDoesNotLookLikeAWonOne) {
  const Fixture fixture({"idle", "baseline"});
  const Tally tally = run(fixture.task({.horizon = ticks(60)}), 120);
  EXPECT_GT(tally.gains[1][1], 0);
}

TEST(Race, TheAwaySideSeesItTheOtherWayRound) {
  const auto playbook = io::prepare_playbook({.strategies = {"baseline", "idle"}, .own = Side::away});
  ASSERT_TRUE(playbook);
  const Situation situation{.state = random_situation(playbook->params.front(), {.seed = 5}), .doubt = {}};
  const Tally tally = run(io::task_of(*playbook, {0, 1}, situation, {.horizon = ticks(60)}, {.seed = 100}), 120);
  EXPECT_LT(tally.gains[1][1], 0);
}

TEST(Race, KeepsPathsAndTheBallsHeat) {
  const Fixture fixture({"baseline", "kick_now"});
  const Tally tally = run(fixture.task({.horizon = ticks(30)}), 20);
  for (const int i : {0, 1}) {
    for (const Path& path : tally.accounts[i].paths) {
      EXPECT_EQ(path.points, Path::kPoints);
      EXPECT_FLOAT_EQ(path.spacing, 1);
      EXPECT_EQ(path.ball[0], fixture.situation.state.world.ball.position);
      EXPECT_EQ(path.robots[0][1], fixture.situation.state.world.bodies[1].position);
    }
    std::uint32_t all = 0;
    for (const auto& row : tally.accounts[i].heat.counts)
      for (const std::uint32_t count : row) all += count;
    EXPECT_EQ(all, 10u * 31u) << "each second, the first and the last too";
  }
}

TEST(Race, HalfTimeDoesNotTurnPathsAndHeatRound) {
  Fixture fixture({"baseline"});
  State& state = fixture.situation.state;
  state.book.half = 1;
  state.book.clock = ticks(fixture.playbook.params.front().rules.half_duration - 4);
  const Tally tally = run(fixture.task({.until = Until::game}), 8);
  const Path& path = tally.accounts[0].paths[0];
  ASSERT_EQ(path.points, Path::kPoints) << "two minutes, of which 4 s are of the first half";
  for (int point = 0; point < path.points; ++point)
    EXPECT_LE(path.robots[point][0].x, 0) << "the keeper at " << point << " stays in its half";
}

}  // namespace
}  // namespace sim::foresight
