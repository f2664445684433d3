#include <gtest/gtest.h>

#include "tests/sim/referee/scene.h"

namespace sim::referee {
namespace {

Names twice_around(Scene& scene) {
  scene.pass(12);
  return scene.told();
}

TEST(Pushing, RemovesThePushingRobotAndNotThePushedOne) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    scene.start_play();
    scene.robot(Side::home, 2).pushing = 14;
    scene.robot(Side::home, 2).touching = scene.robot(Side::away, 2).touching = 90;
    EXPECT_EQ(twice_around(scene), Names{});
    scene.robot(Side::home, 2).pushing = 15;
    EXPECT_EQ(twice_around(scene), Names{"pushing home"});
    EXPECT_EQ(scene.robot(Side::home, 2).doing, Body::Doing::removed);
  }
}

TEST(IllegalDefender, OnlyTheGoalkeeperMayBeInTheGoalArea) {
  Scene scene(rules_2012());
  scene.start_play();
  scene.stand(Side::home, 1, {-2.8f, 0});     // the goalkeeper
  scene.stand(Side::home, 2, {-2.3f, 0});     // before the area
  scene.stand(Side::home, 3, {-2.8f, 1.2f});  // beside it
  scene.stand(Side::away, 3, {-2.8f, 0.5f});  // an attacker
  EXPECT_EQ(twice_around(scene), Names{});
  scene.stand(Side::home, 4, {-2.45f, 1});
  EXPECT_EQ(twice_around(scene), Names{"illegal defender home"});

  Scene later(rules_2025());
  later.start_play();
  later.stand(Side::home, 4, {-4.3f, 0});
  EXPECT_EQ(twice_around(later), Names{});
}

TEST(Leaving, RemovesARobotThatLeavesTheCarpet) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    scene.start_play();
    scene.stand(Side::away, 2, {0, rules.field.width / 2 + 0.69f});
    EXPECT_EQ(twice_around(scene), Names{});
    scene.stand(Side::away, 2, {rules.field.length / 2 + 0.71f, 0});
    EXPECT_EQ(twice_around(scene), Names{"leaving away"});
  }
}

TEST(LocalStuck, RemovesTheNearestOfSeveralRobots) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    scene.start_play();
    scene.ball().position = {1, 1};
    scene.stand(Side::home, 2, {0.8f, 1});
    scene.stand(Side::away, 2, {1.3f, 1});
    for (int second = 0; second < 29; ++second) scene.touch(Side::home, 2), scene.pass(29);
    EXPECT_EQ(scene.told(), Names{});
    for (int second = 0; second < 2; ++second) scene.touch(Side::home, 2), scene.pass(29);
    EXPECT_EQ(scene.told(), Names{"local stuck home"});
    EXPECT_EQ(scene.robot(Side::home, 2).doing, Body::Doing::removed);
  }
}

TEST(LocalStuck, DoesNotApplyWhenTheBallGetsAwayOrOneRobotIsAlone) {
  Scene scene(rules_2025());
  scene.start_play();
  scene.stand(Side::home, 2, {0.2f, 0});
  for (int second = 0; second < 40; ++second) scene.touch(Side::home, 2), scene.pass(29);
  EXPECT_EQ(scene.told(), Names{});
  for (int second = 0; second < 40; ++second) {
    scene.ball().position.x += 0.02f;
    scene.stand(Side::home, 2, scene.ball().position - Vec2{0.2f, 0});
    scene.stand(Side::away, 2, scene.ball().position + Vec2{0.2f, 0});
    scene.touch(Side::home, 2), scene.pass(29);
  }
  EXPECT_EQ(scene.told(), Names{});
}

TEST(GlobalStuck, GivesTheKickOffToTheSideThatDidNotTouchTheBallLast) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    scene.start_play();
    scene.touch(Side::home, 2);
    scene.pass_seconds(29.5f);
    EXPECT_EQ(scene.told(), Names{});
    scene.pass_seconds(1);
    EXPECT_EQ(scene.told(), (Names{"global stuck away", "ready away"}));
  }
}

TEST(GlobalStuck, AlternatesWhileNobodyPlays) {
  Scene scene(rules_2012());
  scene.start_play();
  const Side first = scene.book.kicking;
  for (int i = 0; i < 4; ++i) {
    while (scene.book.phase == agent::Game::Phase::playing) scene.pass();
    EXPECT_EQ(scene.book.kicking == first, i % 2 == 1);
    while (scene.book.phase != agent::Game::Phase::playing) scene.pass();
  }
}

TEST(Penalty, LastsExactlyItsTimeAndGrowsWithEachPenalty) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    scene.start_play();
    for (int i = 0; i < 5; ++i) {
      const int player = 2 + i % 3;
      scene.robot(Side::away, player).pushing = 255;
      while (scene.told() != Names{"pushing away"}) scene.pass();
      const Tick from = scene.events.back().tick;
      const float expected = rules.penalty_duration + rules.penalty_step * static_cast<float>(i);
      while (scene.events.back().kind != Event::Kind::returned) scene.touch(Side::home, 2);
      EXPECT_EQ(scene.events.back().tick - from, ticks(expected));
      EXPECT_EQ(scene.events.back().robot, robot_of(Side::away, player));
      scene.told();
    }
    EXPECT_EQ(scene.book.penalties[0], 0);
    EXPECT_EQ(scene.book.penalties[1], 5);
  }
}

TEST(Penalty, ARemovedRobotComesBackAtTheTouchLineFartherFromTheBall) {
  for (const auto& rules : {rules_2012(), rules_2025()})
    for (const float where : {1.f, -1.f}) {
      Scene scene(rules);
      scene.start_play();
      for (int player = 1; player <= rules.players; ++player)
        scene.stand(Side::away, player, {0.5f * static_cast<float>(player), 0});
      scene.stand(Side::away, 3, {1, 0.5f * where});
      scene.robot(Side::away, 3).pushing = 255;
      scene.robot(Side::away, 3).walked = 12;
      scene.pass(6);
      EXPECT_GT(scene.robot(Side::away, 3).position.y * where, rules.field.width / 2 + rules.field.border);

      scene.ball().position = {0, where};
      while (scene.robot(Side::away, 3).doing == Body::Doing::removed) scene.touch(Side::home, 1);
      const Body& body = scene.robot(Side::away, 3);
      EXPECT_NEAR(body.position.x, rules.field.length / 2 - rules.field.penalty_mark, 1e-6f);
      EXPECT_EQ(body.position.y, -where * rules.field.width / 2);
      EXPECT_EQ(body.facing, (Vec2{0, where}));
      EXPECT_EQ(body.walked, 12);
      EXPECT_EQ(body.pushing, 0);
    }
}

TEST(Penalty, RobotsComeBackSideBySide) {
  field::Rules rules = rules_2012();
  rules.stuck_global = 0;
  Scene scene(rules);
  scene.start_play();
  for (int player = 1; player <= 4; ++player) scene.robot(Side::home, player).pushing = 255;
  scene.pass_seconds(31);
  for (int player = 1; player <= 4; ++player) {
    const Body& body = scene.robot(Side::home, player);
    EXPECT_EQ(body.doing, Body::Doing::standing);
    EXPECT_LT(body.position.x, 0);
    for (int another = 1; another < player; ++another)
      EXPECT_GE(distance(body.position, scene.robot(Side::home, another).position), 0.3f);
  }
}

}  // namespace
}  // namespace sim::referee
