#include <gtest/gtest.h>

#include "tests/sim/referee/scene.h"

namespace sim::referee {
namespace {

using Phase = agent::Game::Phase;
using SetPlay = agent::Game::SetPlay;

agent::Game told_to(const Scene& scene, Side side, int player) {
  return game_for(scene.rules, scene.world, scene.book, robot_of(side, player));
}

TEST(Game, HoldsThePlayerAndTheState) {
  Scene scene(rules_2025());
  scene.start_play();
  scene.pass_seconds(20);
  scene.touch(Side::home, 2);
  scene.book.score[0] = 2;
  scene.book.score[1] = 1;
  const agent::Game home = told_to(scene, Side::home, 3), away = told_to(scene, Side::away, 5);
  EXPECT_EQ(home.player, 3);
  EXPECT_EQ(away.player, 5);
  EXPECT_EQ(home.players, 7);
  EXPECT_EQ(home.own_score, 2);
  EXPECT_EQ(away.own_score, 1);
  EXPECT_EQ(away.opponent_score, 2);
  EXPECT_EQ(home.phase, Phase::playing);
  EXPECT_EQ(home.set_play, SetPlay::none);
  EXPECT_FALSE(home.own_kick);
  EXPECT_NEAR(home.remaining, 570, 0.1f);
  EXPECT_NEAR(home.since_phase, 20, 0.1f);
}

TEST(Game, AKickBelongsToOneSide) {
  Scene scene(rules_2025());
  scene.start_play();
  scene.carry(Side::home, 2, {1, 2.9f}, {1, 3.1f});
  EXPECT_EQ(told_to(scene, Side::home, 1).set_play, SetPlay::kick_in);
  EXPECT_FALSE(told_to(scene, Side::home, 1).own_kick);
  EXPECT_TRUE(told_to(scene, Side::away, 1).own_kick);
  EXPECT_NEAR(told_to(scene, Side::away, 1).since_phase, 0, 0.1f);
  scene.touch(Side::away, 2);
  EXPECT_FALSE(told_to(scene, Side::away, 1).own_kick);
}

TEST(Game, AGoalIsReportedLateIn2025AndAtOnceIn2012) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    scene.start_play();
    scene.pass_seconds(5);
    const float line = rules.field.length / 2;
    scene.carry(Side::home, 2, {line - 0.1f, 0}, {line + 0.1f, 0});
    for (Tick tick = 0; tick + 1 < ticks(rules.goal_message_delay); ++tick) {
      const agent::Game home = told_to(scene, Side::home, 2), away = told_to(scene, Side::away, 2);
      ASSERT_EQ(home.phase, Phase::playing);
      ASSERT_EQ(home.set_play, SetPlay::none);
      ASSERT_EQ(home.own_score + home.opponent_score + away.own_score + away.opponent_score, 0);
      ASSERT_GT(home.since_phase, 5);
      ASSERT_NE(scene.ball().position, Vec2{}) << "still in the goal";
      scene.pass();
    }
    scene.pass();
    const agent::Game home = told_to(scene, Side::home, 2), away = told_to(scene, Side::away, 2);
    EXPECT_EQ(home.phase, Phase::ready);
    EXPECT_EQ(home.own_score, 1);
    EXPECT_EQ(away.opponent_score, 1);
    EXPECT_TRUE(away.own_kick);
    EXPECT_EQ(scene.ball().position, Vec2{});
  }
}

TEST(Game, APenalisedRobotIsInformed) {
  Scene scene(rules_2012());
  scene.start_play();
  scene.robot(Side::home, 2).pushing = 255;
  scene.pass(6);
  EXPECT_TRUE(told_to(scene, Side::home, 2).penalised);
  EXPECT_FALSE(told_to(scene, Side::home, 3).penalised);
  scene.pass_seconds(31);
  EXPECT_FALSE(told_to(scene, Side::home, 2).penalised);
}

}  // namespace
}  // namespace sim::referee
