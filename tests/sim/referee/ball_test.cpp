#include <gtest/gtest.h>

#include <random>

#include "tests/sim/referee/scene.h"

namespace sim::referee {
namespace {

/// One case of a ball that leaves the field, from the rule books.
struct BallOutCase {
  const char* what;
  bool in_2025;
  Side last;
  Vec2 from, to;
  Names told;
  Vec2 placed;
};

TEST(BallOut, FollowsTheRulesOfTheYear) {
  const Side home = Side::home, away = Side::away;
  const BallOutCase cases[] = {
      {"2012 touch line by home: 1 m back", false, home, {1, 1.9f}, {1, 2.1f}, {"out home"}, {0, 1.6f}},
      {"2012 touch line by away: 1 m back", false, away, {1, -1.9f}, {1, -2.1f}, {"out away"}, {2, -1.6f}},
      {"2012 back, but not into the corner", false, home, {-2.5f, 1.9f}, {-2.5f, 2.1f}, {"out home"}, {-2, 1.6f}},
      {"2012 own goal line", false, home, {-2.9f, 1}, {-3.1f, 1}, {"out home"}, {-2, 1.6f}},
      {"2012 other goal line, far shot", false, home, {-1.5f, -1.5f}, {3.1f, -1}, {"out home"}, {-2, -1.6f}},
      {"2012 other goal line, near shot", false, home, {2.5f, -1}, {3.1f, -1}, {"out home"}, {0, -1.6f}},
      {"2012 away over its own goal line", false, away, {2.9f, -1}, {3.1f, -1}, {"out away"}, {2, -1.6f}},
      {"2025 touch line by home", true, home, {1, 2.9f}, {1, 3.1f}, {"kick-in away"}, {1, 3}},
      {"2025 touch line by away", true, away, {-4, -2.9f}, {-4, -3.1f}, {"kick-in home"}, {-4, -3}},
      {"2025 other goal line by home", true, home, {4.4f, 2}, {4.6f, 2}, {"goal kick away"}, {3.9f, 1.1f}},
      {"2025 own goal line by home", true, home, {-4.4f, 2}, {-4.6f, 2}, {"corner kick away"}, {-4.5f, 3}},
      {"2025 other goal line by away", true, away, {-4.4f, -2}, {-4.6f, -2}, {"goal kick home"}, {-3.9f, -1.1f}},
      {"2025 own goal line by away", true, away, {4.4f, -2}, {4.6f, -2}, {"corner kick home"}, {4.5f, -3}},
  };
  for (const BallOutCase& at : cases) {
    Scene scene(at.in_2025 ? rules_2025() : rules_2012());
    scene.start_play();
    scene.carry(at.last, 2, at.from, at.to);
    EXPECT_EQ(scene.told(), at.told) << at.what;
    EXPECT_NEAR(distance(scene.ball().position, at.placed), 0, 1e-5f) << at.what;
    EXPECT_EQ(scene.book.phase, agent::Game::Phase::playing) << at.what;
    EXPECT_EQ(scene.book.ball_free, !at.in_2025) << at.what;
  }
}

TEST(BallOut, TheLineBelongsToTheField) {
  Scene scene(rules_2012());
  scene.start_play();
  scene.carry(Side::home, 2, {1, 1.9f}, {1, 2.07f});
  EXPECT_EQ(scene.told(), Names{});
  scene.ball().position.y = 2.08f;
  scene.pass();
  EXPECT_EQ(scene.told(), Names{"out home"});
}

TEST(SetPlay, IsFreeWhenItsSideTouchesTheBallOrItsTimeIsUp) {
  Scene scene(rules_2025());
  scene.start_play();
  scene.carry(Side::home, 2, {1, 2.9f}, {1, 3.1f});
  scene.told();
  scene.touch(Side::away, 3);
  EXPECT_EQ(scene.told(), Names{"ball free away"});

  scene.carry(Side::home, 2, {1, 2.9f}, {1, 3.1f});
  scene.told();
  scene.pass_seconds(30);
  EXPECT_EQ(scene.told(), Names{"ball free away"});
}

TEST(SetPlay, TheOtherSideKeepsAwayFromTheBall) {
  Scene scene(rules_2025());
  scene.start_play();
  scene.carry(Side::home, 2, {1, 2.9f}, {1, 3.1f});
  scene.told();

  // a robot that stands there has time to leave; a ball that it moves is put back
  scene.ball().position = {1.2f, 2.8f};
  scene.touch(Side::home, 2);
  EXPECT_EQ(scene.told(), Names{});
  EXPECT_EQ(scene.ball().position, (Vec2{1, 3}));

  // a robot that stays is removed, and so is one that touches the ball later
  scene.stand(Side::home, 2, {1, 2.5f});
  scene.stand(Side::home, 3, {1, 2.2f});
  scene.pass_seconds(10);
  scene.pass(6);
  EXPECT_EQ(scene.told(), Names{"illegal position home"});
  EXPECT_NE(scene.book.penalised_until[robot_of(Side::home, 2)], 0u);
  scene.touch(Side::home, 3);
  EXPECT_EQ(scene.told(), Names{"illegal kick home"});
  EXPECT_FALSE(scene.book.ball_free);
}

TEST(KickOff, TheOtherSideStaysOutOfTheCircleUntilTheBallIsFree) {
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    while (scene.book.phase != agent::Game::Phase::playing) scene.pass();
    scene.told();
    const Side others = other(scene.book.kicking);
    const std::string side = others == Side::home ? " home" : " away";
    scene.stand(others, 2, {0, rules.clear_distance - 0.01f});
    scene.stand(others, 3, {0, rules.clear_distance + 0.01f});
    scene.stand(scene.book.kicking, 2, {0, 0.2f});
    scene.pass(6);
    EXPECT_EQ(scene.told(), Names{"illegal position" + side});
    scene.touch(others, 3);
    EXPECT_EQ(scene.told(), Names{"illegal kick" + side});
    EXPECT_EQ(scene.ball().position, Vec2{});
  }
}

TEST(Goal, CountsForTheSideThatAttacksThere) {
  for (const auto& rules : {rules_2012(), rules_2025()})
    for (const Side last : {Side::home, Side::away})
      for (const float end : {1.f, -1.f}) {
        Scene scene(rules);
        scene.start_play();
        const float line = rules.field.length / 2;
        scene.carry(last, 2, {end * (line - 0.1f), 0.3f}, {end * (line + 0.1f), 0.35f});
        const Names expected = end > 0 ? Names{"goal home", "ready away"} : Names{"goal away", "ready home"};
        EXPECT_EQ(scene.told(), expected);
        EXPECT_EQ(scene.book.score[0], end > 0 ? 1 : 0);
        EXPECT_EQ(scene.book.score[1], end > 0 ? 0 : 1);
      }
}

TEST(Goal, DirectlyFromAKickOffCountsOnlyWhereTheRulesAllowIt) {
  for (const bool direct : {true, false})
    for (const bool by_another : {false, true}) {
      Scene scene(rules_2012());
      scene.rules.kick_off_goal = direct;
      while (scene.book.phase != agent::Game::Phase::playing) scene.pass();
      scene.told();
      const Side kicking = scene.book.kicking;
      const float end = kicking == Side::home ? 1 : -1;  // home attacks towards +x in the first half

      // the kicker touches the ball inside the circle; then a teammate or nobody touches it before the goal
      scene.ball().position = {end * 0.1f, 0};
      scene.touch(kicking, 2);
      if (by_another) scene.touch(kicking, 3);
      scene.ball().position = {end * 2.95f, 0};
      scene.pass();
      scene.told();
      scene.ball().position = {end * 3.2f, 0};
      scene.pass();
      EXPECT_EQ(scene.book.score[static_cast<int>(kicking)], direct || by_another ? 1 : 0);
      EXPECT_EQ(scene.told().size(), direct || by_another ? 2u : 1u);
    }
}

TEST(Goal, MayBeScoredByTheKickerOnceItTouchedTheBallOutsideTheCircle) {
  Scene scene(rules_2012());
  scene.rules.kick_off_goal = false;
  while (scene.book.phase != agent::Game::Phase::playing) scene.pass();
  const Side kicking = scene.book.kicking;
  const float end = kicking == Side::home ? 1 : -1;
  scene.touch(kicking, 2);
  scene.carry(kicking, 2, {end * 1.5f, 0}, {end * 2.95f, 0});
  scene.ball().position = {end * 3.2f, 0};
  scene.pass();
  EXPECT_EQ(scene.book.score[static_cast<int>(kicking)], 1);
}

TEST(Goal, NeedsTheWholeBallOverTheLine) {
  Scene scene(rules_2012());
  scene.start_play();
  scene.carry(Side::home, 2, {2.9f, 0}, {3.07f, 0});
  EXPECT_EQ(scene.told(), Names{});
}

TEST(Goal, IsNeverGivenFromBehindTheGoalLineOrBesideThePosts) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> share(-1, 1);
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    int goals = 0;
    for (int i = 0; i < 3000; ++i) {
      Scene scene(rules);
      scene.book.phase = agent::Game::Phase::playing;
      scene.book.ball_free = true;
      scene.book.clock = 1;
      const float end = rules.field.length / 2 + 0.075f, side = rules.field.width / 2 + 0.075f;
      const Vec2 from{end * 1.1f * share(random), side * 1.1f * share(random)};
      const Vec2 to{end * 1.3f * share(random), side * 1.3f * share(random)};
      scene.told();
      scene.book.ball_before = from;
      scene.ball().position = to;
      scene.pass();

      // the same rule, computed here: the ball was inside and crosses the line between the posts
      const bool inside = std::abs(from.x) <= end && std::abs(from.y) <= side;
      const float at = from.y + (to.y - from.y) * (end - std::abs(from.x)) / (std::abs(to.x) - std::abs(from.x));
      const int given = scene.book.score[0] + scene.book.score[1];
      goals += given;
      if (!given) continue;
      EXPECT_TRUE(inside);
      EXPECT_GT(std::abs(to.x), end);
      if (from.x * to.x > 0) {
        EXPECT_LT(std::abs(at), rules.field.goal_width / 2 + 1e-3f);
      }
    }
    EXPECT_GT(goals, 20);
  }
}

TEST(BallOut, TheBallIsInsideTheFieldWhenPlayGoesOn) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> share(-1, 1);
  for (const auto& rules : {rules_2012(), rules_2025()}) {
    Scene scene(rules);
    int score = 0;
    for (int i = 0; i < 1000; ++i) {
      if (!scene.book.ball_free) scene.start_play();
      const Side side = share(random) < 0 ? Side::home : Side::away;
      const Vec2 from{rules.field.length / 2 * share(random), rules.field.width / 2 * share(random)};
      scene.carry(side, 3, from, from + Vec2{3 * share(random), 3 * share(random)});
      if (scene.book.phase == agent::Game::Phase::playing) {
        EXPECT_LE(std::abs(scene.ball().position.x), rules.field.length / 2 + 0.075f);
        EXPECT_LE(std::abs(scene.ball().position.y), rules.field.width / 2 + 0.075f);
      }
      EXPECT_GE(scene.book.score[0] + scene.book.score[1], score) << "the score only grows";
      score = scene.book.score[0] + scene.book.score[1];
      if (scene.book.phase == agent::Game::Phase::finished) scene = Scene(rules), score = 0;
    }
  }
}

}  // namespace
}  // namespace sim::referee
