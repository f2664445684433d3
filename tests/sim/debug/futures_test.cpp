#include "sim/debug/futures.h"

#include <gtest/gtest.h>

#include "sim/match/hash.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::setup_of;
using test::timeline_of;

TEST(Futures, WithoutAChangeNothingDiffers) {
  const SharedSetup setup = setup_of("baseline", "baseline", 120);
  Timeline timeline = timeline_of(setup, 1);
  const Moment moment{setup, timeline.at(1500)};
  const Futures result = futures(moment, moment, Side::home, 20, ticks(20));
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
  const Moment without{idle, state}, with{plays, state};
  const Futures home = futures(without, with, Side::home, 40, ticks(60));
  EXPECT_GT(home.scores.low, 0) << text_of(home, ticks(60));
  EXPECT_EQ(home.different, 40);
  const Futures away = futures(without, with, Side::away, 40, ticks(60));
  EXPECT_EQ(away.concedes.low, home.scores.low);
  EXPECT_EQ(away.goals.high, -home.goals.low);
}

TEST(Futures, TheFirstPairHasTheLuckOfTheGame) {
  const SharedSetup setup = setup_of("baseline", "baseline", 120), idle = setup_of("idle", "baseline", 120);
  Timeline timeline = timeline_of(setup, 1);
  const State state = timeline.at(1500);
  const Futures result = futures({setup, state}, {idle, state}, Side::home, 2, ticks(20));
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

}  // namespace
}  // namespace sim::debug
