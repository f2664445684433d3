#include "sim/debug/futures.h"

#include <gtest/gtest.h>

#include "sim/match/hash.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::setup_of;
using test::timeline_of;

/// Plays `count` pairs of this one.
Futures played(const Pair& pair, Side side, int count, Tick length) {
  return futures(std::vector<Pair>(static_cast<std::size_t>(count), pair), robot_of(side, 2), length);
}

TEST(Futures, WithoutAChangeNothingDiffers) {
  const SharedSetup setup = setup_of("baseline", "baseline", 120);
  Timeline timeline = timeline_of(setup, 1);
  const Moment moment{setup, timeline.at(1500)};
  const Futures result = played({moment, moment}, Side::home, 20, ticks(20));
  EXPECT_EQ(result.different, 0);
  EXPECT_FALSE(result.parting);
  EXPECT_EQ(result.goals.low, 0);
  EXPECT_EQ(result.goals.high, 0);
  EXPECT_NE(text_of(result, ticks(20)).find("with the luck of this game nothing differs"), std::string::npos);
}

TEST(Futures, AChangeForTheBetterHasAnIntervalAboveZeroAndTheOppositeOneForTheOtherSide) {
  const SharedSetup idle = setup_of("idle", "idle", 120), plays = setup_of("baseline", "idle", 120);
  Timeline timeline = timeline_of(plays, 1);
  const State state = timeline.at(1500);
  const Pair pair{{idle, state}, {plays, state}};
  const Futures home = played(pair, Side::home, 40, ticks(60));
  EXPECT_GT(home.scores.low, 0) << text_of(home, ticks(60));
  EXPECT_EQ(home.different, 40);
  const Futures away = played(pair, Side::away, 40, ticks(60));
  EXPECT_EQ(away.concedes.low, home.scores.low);
  EXPECT_EQ(away.goals.high, -home.goals.low);
}

TEST(Futures, TheFirstPairHasTheLuckOfTheGame) {
  const SharedSetup setup = setup_of("baseline", "baseline", 120), idle = setup_of("idle", "baseline", 120);
  Timeline timeline = timeline_of(setup, 1);
  const State state = timeline.at(1500);
  const Futures result = played({{setup, state}, {idle, state}}, Side::home, 2, ticks(20));
  ASSERT_TRUE(result.parting);
  EXPECT_GT(*result.parting, 1500u);
  EXPECT_NE(result.field, "");

  // played by hand
  Timeline changed = timeline;
  changed.change(state, idle);
  const auto differ = [&](Tick tick) { return hash_of(changed.at(tick)) != hash_of(timeline.at(tick)); };
  EXPECT_TRUE(differ(*result.parting));
  EXPECT_FALSE(differ(*result.parting - 1));
}

TEST(Futures, AFewPathsAreKept) {
  const SharedSetup setup = setup_of("baseline", "baseline", 120), idle = setup_of("idle", "baseline", 120);
  Timeline timeline = timeline_of(setup, 1);
  const State state = timeline.at(1500);
  const Futures result = played({{setup, state}, {idle, state}}, Side::away, 20, ticks(10));
  ASSERT_EQ(result.paths_without.size(), static_cast<std::size_t>(Futures::kPaths));
  ASSERT_EQ(result.paths_with.size(), result.paths_without.size());
  for (const FuturePath& path : result.paths_without) {
    EXPECT_EQ(path.ball.front(), state.world.ball.position);
    EXPECT_EQ(path.robot.front(), state.world.bodies[robot_of(Side::away, 2)].position);
    EXPECT_LE(path.ball.size(), 1u + ticks(10) / FuturePath::kSpacing);
    EXPECT_EQ(path.ball.size(), path.robot.size());
  }
  // the first one is that of the game
  const std::vector<Vec2>& first = result.paths_without.front().ball;
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_EQ(first[i], timeline.at(1500 + static_cast<Tick>(i) * FuturePath::kSpacing).world.ball.position);
}

}  // namespace
}  // namespace sim::debug
