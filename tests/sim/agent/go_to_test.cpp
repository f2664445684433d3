#include "sim/agent/go_to.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/agent/past.h"
#include "tests/sim/agent/practice.h"

namespace sim::agent {
namespace {

Tree going(const std::string& with) {
  return tree_of(R"({"name": "g", "tree": {"do": "go_to", "with": {)" + with + "}}}");
}

/// Lets a robot walk for a minute, with the ball at (2, 1). Returns its pose.
Pose2 end_of(const std::string& with, Pose2 from) {
  Practice practice(going(with), from, {2, 1});
  for (int tick = 0; tick < 30 * 60; ++tick) practice.step();
  EXPECT_EQ(practice.body().velocity, Vec2{});
  return {practice.body().position, practice.body().heading};
}

TEST(GoTo, ReachesThePointAndFacesWhatItShall) {
  for (const Pose2 from : {Pose2{{1, 1}, 0}, Pose2{{-2, -1.5f}, 3}, Pose2{{0, 2}, -2}}) {
    const std::string point = R"("point": [-1.5, 0.5])";
    const Pose2 ball = end_of(point, from), goal = end_of(point + R"(, "face": "goal")", from),
                way = end_of(point + R"(, "direction": "-90 deg")", from);
    for (const Pose2& end : {ball, goal, way}) EXPECT_LT(distance(end.position, {-1.5f, 0.5f}), 0.15f);
    EXPECT_GT(dot(direction(ball.heading), unit(Vec2{2, 1} - ball.position)), 0.9f);
    EXPECT_GT(dot(direction(goal.heading), unit(Vec2{3, 0} - goal.position)), 0.9f);
    EXPECT_GT(dot(direction(way.heading), Vec2{0, -1}), 0.9f);
  }
}

TEST(GoTo, GoesRoundARobotInTheWay) {
  const TreeBehaviour behaviour(going(R"("point": [2, 0])"));
  Scene scene;
  EXPECT_NEAR(scene.decide(behaviour).walk.y, 0, 1e-4f);
  scene.see_opponent(3, {0.8f, 0.1f});
  const Vec2 step = scene.decide(behaviour).walk;
  // the straight way to this step misses the robot
  EXPECT_GT(std::abs(cross(unit(step), {0.8f, 0.1f})), 0.95f * scene.settings.habits.avoid_radius);
}

TEST(GoTo, APointOutsideTheLinesIsMovedOntoThem) {
  const TreeBehaviour behaviour(going(R"("point": [8, -6])"));
  Scene scene;
  const View view = scene.view();
  EXPECT_EQ(view.to_team(scene.decide(behaviour).walk), (Vec2{view.half_length, -view.half_width}));
}

TEST(Past, TheWayOfTheBallMissesTheNearestOpponentByTheRoom) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> coordinate(-1.5f, 1.5f), angle(-3.1f, 3.1f), width(0.2f, 0.6f);
  int turned_away = 0;
  for (int n = 0; n < 5000; ++n) {
    Scene scene;
    scene.see_ball({coordinate(random), coordinate(random)});
    scene.see_opponent(2, {coordinate(random), coordinate(random)});
    scene.mind.search_side = n % 2 == 0 ? 1 : -1;
    const View view = scene.view();
    const float room = width(random);
    const Vec2 way = direction(angle(random)), past = past_nearest(view, way, room);
    const Vec2 offset = view.to_robot(scene.beliefs.opponents[1].position) - view.ball;
    if (length(offset) > 1.5f) continue;  // too far away to go round it now
    EXPECT_NEAR(length(past), 1, 1e-4f);
    const float along = dot(past, offset);
    const float nearest = along > 0 ? std::abs(cross(past, offset)) : length(offset);
    EXPECT_GE(nearest, std::min(room, length(offset)) - 1e-3f) << n;
    turned_away += past != way;
  }
  EXPECT_GT(turned_away, 300);
}

TEST(Past, WithoutAnOpponentInTheWayTheBallGoesStraight) {
  Scene scene;
  EXPECT_EQ(past_nearest(scene.view(), {1, 0}, 0.4f), (Vec2{1, 0}));
  for (const Vec2 opponent : {Vec2{0.5f, 0}, Vec2{1.6f, 0.5f}, Vec2{3, 0}}) {
    scene.see_opponent(2, opponent);
    EXPECT_EQ(past_nearest(scene.view(), {1, 0}, 0.4f), (Vec2{1, 0})) << opponent.x;
  }
}

TEST(Past, TheBallStaysInTheField) {
  for (const float side : {1.f, -1.f}) {
    Scene scene;
    const float line = scene.view().half_width;
    scene.beliefs.pose.pose.position = {0, side * (line - 0.3f)};
    // the opponent stands a little inside, so the shorter way round it leads out
    scene.see_opponent(2, {1.6f, side * (line - 0.35f)});
    EXPECT_LT(side * past_nearest(scene.view(), {1, 0}, 0.4f).y, 0);
  }
}

/// The opponent stands still; the dribbling robot reaches the goal line with the ball and never pushes it into it.
TEST(Past, ADribbleComesPastAnOpponentThatStands) {
  for (const float y : {0.f, 0.15f, -0.15f}) {
    const auto nearest = [&](const char* past) {
      Practice practice(
          tree_of(std::string(R"({"name": "d", "tree": {"do": "dribble", "with": {"direction": 0, "past": ")") + past +
                  R"("}}})"),
          {{-0.5f, 0}, 0}, {0, 0});
      const Vec2 opponent{1.2f, y};
      float least = 10;
      for (int tick = 0; tick < 30 * 40 && practice.world.ball.position.x < 2; ++tick) {
        practice.scene.see_opponent(2, opponent);
        practice.scene.beliefs.opponents[1].seen = practice.world.tick;
        practice.step();
        // the feet push the ball ahead
        Vec2& ball = practice.world.ball.position;
        const Vec2 offset = ball - practice.body().position;
        if (length(offset) < 0.17f) ball = practice.body().position + 0.17f * unit(offset);
        least = std::min(least, distance(ball, opponent));
      }
      return std::pair{least, practice.world.ball.position.x};
    };
    const auto [straight, straight_x] = nearest("nobody");
    const auto [past, past_x] = nearest("nearest");
    EXPECT_LT(straight, 0.2f);
    EXPECT_GT(past, 0.25f) << y;  // more than robot and ball
    EXPECT_GE(past_x, 2) << y;
  }
}

}  // namespace
}  // namespace sim::agent
