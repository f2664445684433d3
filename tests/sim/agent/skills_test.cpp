#include "sim/agent/skills.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "sim/agent/ball_skills.h"
#include "sim/agent/place_skills.h"
#include "sim/agent/walk.h"
#include "tests/sim/agent/practice.h"

namespace sim::agent {
namespace {

using Command = motion::Command;

TEST(Skills, AreFoundByTheirNameAndHaveParametersWithinTheirRange) {
  for (int i = 0; i < skill_count(); ++i) {
    const SkillInfo& info = info_of(static_cast<Skill>(i));
    EXPECT_EQ(find_skill(info.name), static_cast<Skill>(i));
    std::set<std::string> names;
    for (int k = 0; k < info.count; ++k) {
      const ParameterInfo& parameter = info.parameters[k];
      EXPECT_TRUE(names.insert(parameter.name).second);
      if (!is_given(parameter.standard)) continue;
      EXPECT_LE(parameter.range.least, parameter.standard) << info.name << " " << parameter.name;
      EXPECT_GE(parameter.range.most, parameter.standard) << info.name << " " << parameter.name;
      EXPECT_TRUE(!parameter.range.lateral || parameter.standard == 0);
    }
  }
  EXPECT_EQ(find_skill("fly"), kNoSkill);
}

/// From all sides the robot comes round the ball, never into it, and shoots at the goal.
TEST(Skills, FromAllSidesTheRobotComesRoundTheBallAndShootsAtTheGoal) {
  for (const char* strategy : {"align_first", "baseline", "kick_now"}) {
    const float tolerance = std::string(strategy) == "align_first" ? 0.08f : 1.3f;
    for (int n = 0; n < 24; ++n) {
      const float angle = 0.26f * static_cast<float>(n);
      const Vec2 ball{0.4f, 0.5f};
      Practice practice(strategy, {ball + 1.2f * direction(angle), normalized(1.7f * angle)}, ball);
      bool kicked = false;
      for (int tick = 0; tick < 30 * 40 && !kicked; ++tick) kicked = practice.step();
      ASSERT_TRUE(kicked) << strategy << " from " << angle;
      EXPECT_GT(practice.nearest, 0.13f) << strategy << " from " << angle;
      const Vec2 wanted = Vec2{3, 0} - ball, rolls = practice.world.ball.velocity;
      EXPECT_LT(std::abs(atan2(cross(wanted, rolls), dot(wanted, rolls))), tolerance) << strategy << " from " << angle;
    }
  }
}

TEST(Skills, OnTheWayToItsSetPlayTheRobotFacesTheWayRoundAnOpponent) {
  for (const bool ours : {true, false}) {
    Scene scene;
    scene.game.set_play = ours ? Game::SetPlay::kick_in : Game::SetPlay::none;
    scene.game.own_kick = ours;
    scene.game.since_phase = 2;
    scene.beliefs.pose.pose = {};
    scene.see_ball({0.5f, 1.9f});
    scene.see_opponent(2, {0.12f, 0.5f});
    const Command command = kick(scene.view(), scene.mind, {});
    ASSERT_EQ(command.body, Command::Body::walk_to);
    EXPECT_EQ(std::abs(command.turn - angle_of(command.walk)) < 0.01f, ours);
  }
}

TEST(Skills, KickingAtOnceIsQuickerThanAligning) {
  const auto time_until_kick = [](const char* strategy) {
    int total = 0;
    for (int n = 0; n < 12; ++n) {
      const float angle = 0.52f * static_cast<float>(n);
      Practice practice(strategy, {0.8f * direction(angle), normalized(angle + 3)}, {0, 0});
      while (!practice.step() && practice.world.tick < 5000) ++total;
    }
    return total;
  };
  const int now = time_until_kick("kick_now"), baseline = time_until_kick("baseline"),
            aligned = time_until_kick("align_first");
  EXPECT_LT(now, baseline);
  EXPECT_LT(baseline, aligned);
}

TEST(Skills, KicksWithTheLegNearerToTheBall) {
  const TreeBehaviour behaviour(tree_of(R"({"name": "k", "tree": {"do": "kick", "with": {"aim": "ahead"}}})"));
  for (const float side : {1.f, -1.f}) {
    Scene scene;
    scene.see_ball({0.19f, side * 0.05f});
    const Command command = scene.decide(behaviour);
    EXPECT_EQ(command.body, Command::Body::kick);
    EXPECT_EQ(command.kick_left, side > 0);
    // not a ball that rolls, nor one that was not seen recently
    scene.beliefs.ball.velocity = {0.6f, 0};
    EXPECT_NE(scene.decide(behaviour).body, Command::Body::kick);
    scene.see_ball({0.19f, side * 0.05f});
    scene.beliefs.ball.seen = scene.now - 30;
    EXPECT_NE(scene.decide(behaviour).body, Command::Body::kick);
  }
}

TEST(Skills, KicksOnlyAfterTheBallLayRightForThisManyFrames) {
  const TreeBehaviour behaviour(
      tree_of(R"({"name": "k", "tree": {"do": "kick", "with": {"aim": "ahead", "frames": 3}}})"));
  Scene scene;
  scene.see_ball({0.19f, 0.05f});
  EXPECT_NE(scene.decide(behaviour).body, Command::Body::kick);
  EXPECT_NE(scene.decide(behaviour).body, Command::Body::kick);
  EXPECT_EQ(scene.decide(behaviour).body, Command::Body::kick);
}

TEST(Skills, APassGoesAheadOfTheMate) {
  const TreeBehaviour behaviour(tree_of(R"({"name": "p", "tree": {"do": "pass", "with": {"lead": 0.5}}})"));
  Scene scene;
  scene.hear(3, {1.5f, 1}, 4, Role::supporter);
  scene.decide(behaviour);
  // the ball lies at (1, 0): towards (2, 1), as near to its own direction as the tolerance allows
  EXPECT_GT(scene.mind.kick_direction, 0.6f);
  EXPECT_LT(scene.mind.kick_direction, kPi / 4);
}

TEST(Skills, TheKeeperStandsBetweenBallAndGoal) {
  const TreeBehaviour behaviour(tree_of(R"({"name": "k", "tree": {"do": "keep_goal"}})"));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> x(-2, 3), y(-2, 2);
  for (int n = 0; n < 200; ++n) {
    Scene scene;
    scene.game.player = 1;
    const Vec2 ball{x(random), y(random)};
    scene.beliefs.pose.pose.position = {-1, 0};
    scene.see_ball(scene.view().to_robot(ball));
    const Command command = scene.decide(behaviour);
    const Vec2 place = scene.view().to_team(command.walk), goal = scene.view().own_goal();
    EXPECT_LT(std::abs(cross(unit(ball - goal), place - goal)), 0.12f);
    EXPECT_GT(place.x, goal.x);
    EXPECT_LT(distance(place, goal), 0.6f);
  }
}

TEST(Skills, ARobotAtItsPlaceStandsUntilThePlaceIsFarOff) {
  Scene scene;
  const auto go = [&](float off) {
    scene.see_ball({1, 0});
    const Vec2 place = scene.view().to_team({off, 0});
    Position with{.follow_x = 0, .x = place.x, .follow_y = 0, .y = place.y, .distance = 0};
    return position(scene.view(), scene.mind, with).body == motion::Command::Body::walk_to;
  };
  EXPECT_TRUE(go(0.4f)) << "not there yet";
  EXPECT_FALSE(go(0.1f)) << "there";
  EXPECT_FALSE(go(0.4f)) << "still near enough";
  EXPECT_TRUE(go(0.6f));
  EXPECT_TRUE(go(0.4f)) << "on the way it goes on to the place";
}

TEST(Skills, WithoutItsFirstPlayerTheNextOneKicksOff) {
  Scene scene;
  scene.game.player = 3;
  scene.game.own_kick = true;
  const float far = length(ready_place(scene.view()));
  scene.hear(2, {-1, 0}, 1, Role::chaser);
  EXPECT_EQ(length(ready_place(scene.view())), far) << "player 2 is there";
  scene.beliefs.mates[1].active = false;
  EXPECT_LT(length(ready_place(scene.view())), 0.5f) << "player 2 is penalised";
}

TEST(Skills, SearchingTurnsToTheSideWhereTheBallWasLast) {
  const TreeBehaviour behaviour(tree_of(R"({"name": "s", "tree": {"do": "search_ball"}})"));
  for (const float side : {1.f, -1.f}) {
    Scene scene;
    scene.see_ball({1, side});
    scene.decide(behaviour);
    scene.beliefs.ball.seen = kNever;
    std::set<int> bodies;
    float turned_to = 0, widest = 0;
    for (int n = 0; n < 600; ++n) {
      ++scene.now;
      const Command command = scene.decide(behaviour);
      bodies.insert(static_cast<int>(command.body));
      if (command.body == Command::Body::walk_speed) turned_to += command.turn;
      widest = std::max(widest, std::abs(command.look[0]));
    }
    EXPECT_GT(side * turned_to, 0);
    EXPECT_GT(widest, 1.2f);
    EXPECT_EQ(bodies.size(), 3u) << "scans standing, turns and walks";
  }
}

TEST(Skills, TheHeadFollowsTheBallAndLooksAwayNowAndThen) {
  const TreeBehaviour behaviour(shipped("baseline"));
  Scene scene;
  scene.game.player = 3;
  scene.hear(2, {1, 0}, 0.1f, Role::chaser);
  int at_ball = 0, left = 0, right = 0;
  for (int n = 0; n < 900; ++n) {
    ++scene.now;
    scene.see_ball({1, 0});
    scene.hear(2, {1, 0}, 0.1f, Role::chaser);
    const Command command = scene.decide(behaviour);
    if (command.head == Command::Head::look_to)
      ++at_ball;
    else
      ++(command.look[0] > 0 ? left : right);
  }
  EXPECT_GT(at_ball, 450);
  EXPECT_GT(left, 100);
  EXPECT_GT(right, 100);
}

TEST(Skills, OnTheWayToTheOwnSetPlayTheHeadLooksAtTheWayAndNearTheBallAtTheBall) {
  const TreeBehaviour behaviour(tree_of(R"({"name": "k", "tree": {"do": "kick", "with": {"aim": "ahead"}}})"));
  Scene scene;
  scene.game.set_play = Game::SetPlay::corner_kick;
  scene.game.own_kick = true;
  scene.game.since_phase = 2;
  scene.beliefs.ball.seen = kNever;
  scene.mind.ball = {2, 1};  // the corner on the left
  const Vec2 corner = scene.view().ball_in_team;
  scene.beliefs.pose.pose = {corner - Vec2{2, 0}, 0};
  float leftmost = 0, rightmost = 0;
  for (int n = 0; n < 90; ++n) {
    ++scene.now;
    const Command command = scene.decide(behaviour);
    ASSERT_EQ(command.head, Command::Head::angles);
    // a robot that touches this one is above the lower edge of the image (1.07 rad), seen from 0.45 m
    EXPECT_GT(1.07f + command.look[1], std::atan(0.45f / 0.32f));
    leftmost = std::max(leftmost, command.look[0]), rightmost = std::min(rightmost, command.look[0]);
  }
  EXPECT_GT(leftmost, 0.5f);
  EXPECT_LT(rightmost, -0.5f);

  scene.beliefs.pose.pose = {corner - Vec2{0.5f, 0}, 0};
  EXPECT_EQ(scene.decide(behaviour).head, Command::Head::look_to);
}

TEST(Walk, RoundsCirclesWithoutEnteringThem) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> coordinate(-2, 2);
  for (int n = 0; n < 500; ++n) {
    const Vec2 centre{coordinate(random), coordinate(random)}, target{coordinate(random), coordinate(random)};
    constexpr float kRadius = 0.4f;
    if (length(centre) < kRadius || distance(centre, target) < kRadius + 0.01f) continue;
    Vec2 at{};
    float nearest = 10;
    int steps = 0;
    for (; distance(at, target) > 0.03f && steps < 1000; ++steps) {
      const Vec2 way = round_circle(Scene().view(), centre - at, kRadius, target - at, 1);
      at += std::min(0.02f, length(way)) * unit(way);
      nearest = std::min(nearest, distance(at, centre));
    }
    EXPECT_LT(steps, 1000) << n;
    EXPECT_GT(nearest, kRadius - 0.02f) << n;
  }
}

TEST(Walk, RoundsCirclesAtTheEdgeOfTheCarpetOnTheInside) {
  std::mt19937 random(3);
  const field::Field& field = surroundings().rules->field;
  const Vec2 corner{0.5f * field.length, 0.5f * field.width};
  const Vec2 edge = corner + Vec2{field.border, field.border};
  std::uniform_real_distribution<float> x(0, corner.x), y(0, corner.y);
  constexpr float kRadius = 0.9f;
  int went_round = 0;
  for (int n = 0; n < 500; ++n) {
    // the ball of a corner kick, and places in the field
    const Vec2 centre = corner, target{x(random), y(random)};
    Scene scene;
    Vec2& at = scene.beliefs.pose.pose.position = {x(random), y(random)};
    if (distance(centre, at) < kRadius || distance(centre, target) < kRadius + 0.01f) continue;
    int steps = 0;
    for (; distance(at, target) > 0.03f && steps < 2000; ++steps) {
      const View view = scene.view();
      const Vec2 way = round_circle(view, view.to_robot(centre), kRadius, view.to_robot(target), 1);
      went_round += distance(view.to_team(way), target) > 1e-4f;
      at = view.to_team(std::min(0.02f, length(way)) * unit(way));
      ASSERT_TRUE(at.x < edge.x && at.y < edge.y) << n;
      ASSERT_GT(distance(at, centre), kRadius - 0.02f) << n;
    }
    EXPECT_LT(steps, 2000) << n;
  }
  EXPECT_GT(went_round, 50);
}

}  // namespace
}  // namespace sim::agent
