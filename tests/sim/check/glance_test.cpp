#include "sim/check/glance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "tests/sim/check/course.h"

namespace sim::check {
namespace {

using Kind = referee::Event::Kind;

bool happens(std::string_view name, const Glance& glance) {
  for (int i = 0; i < happening_count(); ++i)
    if (happening(i).name == name) return happening(i).holds(glance);
  ADD_FAILURE() << name;
  return false;
}

float value(std::string_view name, const Glance& glance) {
  for (int i = 0; i < quantity_count(); ++i)
    if (quantity(i).name == name) return quantity(i).compute(glance);
  ADD_FAILURE() << name;
  return 0;
}

TEST(Glance, AllWordsDifferAndAreDescribed) {
  std::set<std::string> names;
  for (int i = 0; i < happening_count(); ++i) {
    EXPECT_TRUE(names.insert(happening(i).name).second);
    EXPECT_STRNE(happening(i).about, "");
  }
  for (int i = 0; i < quantity_count(); ++i) {
    EXPECT_TRUE(names.insert(quantity(i).name).second);
    EXPECT_STRNE(quantity(i).about, "");
    EXPECT_LT(quantity(i).least, quantity(i).most);
  }
}

TEST(Glance, TheBallErrorIsTheLeastOfTheRobotsThatSawItInTheLastSecond) {
  Course course;
  const auto error = [&] {
    float seen = 0;
    course.tick([](State&, referee::Events&) {}, [&](const Glance& glance) { seen = value("our_ball_error", glance); });
    return seen;
  };
  EXPECT_TRUE(std::isnan(error()));
  // player 2 stands at (0, 3), faces +y, and sees the ball 0.4 m nearer than it is
  State& now = course.now();
  const int robot = robot_of(Side::home, 2);
  now.world.bodies[robot].facing = {0, 1};
  agent::Ball& ball = now.robots[robot].beliefs.ball;
  ball.position = {-2.6f, 0};
  ball.seen = now.world.tick;
  EXPECT_NEAR(error(), 0.4f, 1e-5f);
  now.robots[robot_of(Side::home, 3)].beliefs.ball = {.position = {5, 5}, .velocity = {}, .seen = now.world.tick};
  EXPECT_NEAR(error(), 0.4f, 1e-5f);
  course.wait(1.1f, [](const Glance&) {});
  EXPECT_TRUE(std::isnan(error()));
}

TEST(Glance, ATouchIsNewIfItIsThatOfAnotherRobotOrHalfASecondLater) {
  Course course;
  int ours = 0, theirs = 0;
  const auto see = [&](const Glance& glance) {
    ours += happens("our touch", glance), theirs += happens("their touch", glance);
  };
  for (int i = 0; i < 20; ++i) course.touch(Side::home, 2, see);  // one long touch
  EXPECT_EQ(ours, 1);
  course.touch(Side::home, 3, see);
  EXPECT_EQ(ours, 2);
  course.wait(0.6f, see);
  course.touch(Side::home, 3, see);
  EXPECT_EQ(ours, 3);
  EXPECT_EQ(theirs, 0);
  course.touch(Side::away, 3, see);
  EXPECT_EQ(theirs, 1);
}

TEST(Glance, APassIsATouchOfAnotherRobotOfTheSameSide) {
  Course course;
  bool passed = false;
  const auto see = [&](const Glance& glance) { passed = happens("our pass", glance); };
  const auto touched_by = [&](Side side, int player) { return course.touch(side, player, see), passed; };
  EXPECT_FALSE(touched_by(Side::home, 2));
  EXPECT_TRUE(touched_by(Side::home, 3));
  EXPECT_FALSE(touched_by(Side::away, 3));
  EXPECT_FALSE(touched_by(Side::home, 2));
  EXPECT_FALSE(touched_by(Side::home, 2));
}

TEST(Glance, HappeningsComeFromTheRefereesEvents) {
  Course course;
  std::string seen;
  const auto see = [&](const Glance& glance) {
    seen.clear();
    for (int i = 0; i < happening_count(); ++i)
      if (happening(i).holds(glance)) seen += std::string(happening(i).name) + ";";
  };
  course.event(Kind::goal, Side::home, see);
  EXPECT_EQ(seen, "our goal;");
  course.event(Kind::goal, Side::away, see);
  EXPECT_EQ(seen, "their goal;");
  course.event(Kind::pushing, Side::away, see, robot_of(Side::away, 2));
  EXPECT_EQ(seen, "their penalty;");
  course.event(Kind::kick_in, Side::home, see);
  EXPECT_EQ(seen, "ball out;");
  course.event(Kind::returned, Side::home, see, robot_of(Side::home, 2));
  EXPECT_EQ(seen, "");
  course.tick([](State& state, referee::Events&) { ++state.counts.shots[1]; }, see);
  EXPECT_EQ(seen, "their shot;");
  course.wait(0.1f, see);
  EXPECT_EQ(seen, "");
}

TEST(Glance, QuantitiesAreThoseOfTheState) {
  Course course;
  course.now().world.ball.position = {1, 2};
  course.now().world.ball.velocity = {3, 4};
  course.now().book.score[0] = 2;
  course.now().world.bodies[robot_of(Side::home, 2)].position = {1, 1.5f};
  course.now().world.bodies[robot_of(Side::away, 4)].doing = Body::Doing::removed;
  course.wait(0.5f, [&](const Glance& glance) {
    EXPECT_EQ(value("ball_x", glance), 1);
    EXPECT_EQ(value("ball_y", glance), 2);
    EXPECT_EQ(value("ball_speed", glance), 5);
    EXPECT_EQ(value("our_goals", glance), 2);
    EXPECT_EQ(value("their_goals", glance), 0);
    EXPECT_EQ(value("our_ball_distance", glance), 0.5f);
    EXPECT_EQ(value("our_players", glance), 4);
    EXPECT_EQ(value("their_players", glance), 3);
  });
  course.now().world.home_attacks = -1;  // the second half
  course.wait(0.1f, [&](const Glance& glance) {
    EXPECT_EQ(value("ball_x", glance), -1);
    EXPECT_EQ(value("ball_y", glance), -2);
    EXPECT_NEAR(value("time", glance), 0.6, 0.11);
  });
  for (int player = 1; player <= 4; ++player)
    course.now().world.bodies[robot_of(Side::home, player)].doing = Body::Doing::removed;
  course.wait(0.1f, [&](const Glance& glance) { EXPECT_TRUE(std::isnan(value("our_ball_distance", glance))); });
}

}  // namespace
}  // namespace sim::check
