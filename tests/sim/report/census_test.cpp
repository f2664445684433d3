#include "sim/report/census.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/json_library.h"
#include "sim/match/step.h"

namespace sim::report {
namespace {

/// One robot a side on the spot, during play. Each robot has its turn at each tick.
State known_state() {
  State state{};
  state.world.players = 1;
  state.world.home_attacks = 1;
  state.world.tick = 100;
  state.book.phase = agent::Game::Phase::playing;
  state.world.touched = state.world.kicked = state.world.whiffed = kNobody;
  for (const Side side : {Side::home, Side::away}) {
    const int robot = robot_of(side, 1);
    Body& body = state.world.bodies[robot];
    body.doing = Body::Doing::standing;
    body.facing = {1, 0};
    state.schedule.lag[robot] = 1;
  }
  return state;
}

/// Shows a step to a census: the state before it, and the state after it with the beliefs.
void show_step(Census& census, State state) {
  census.look(state);
  for (const Side side : {Side::home, Side::away}) {
    const int robot = robot_of(side, 1);
    state.schedule.turn[robot] = state.world.tick + state.schedule.lag[robot];
  }
  ++state.world.tick;
  census.look(state);
}

TEST(Census, MeasuresTheErrorsOfAKnownState) {
  State state = known_state();
  const int robot = robot_of(Side::home, 1);
  state.world.bodies[robot].position = {1, 1};
  state.world.ball.position = {3, 1};
  agent::Beliefs& beliefs = state.robots[robot].beliefs;
  beliefs.ball.visible = true;
  beliefs.ball.position = {2, 0.5f};  // in the robot's frame the ball is at (2, 0)
  beliefs.pose.pose.position = {1, 1.25f};
  Census census;
  show_step(census, state);
  const auto home = census.of(Side::home), away = census.of(Side::away);
  EXPECT_FLOAT_EQ(home["ball_error"].get<float>(), 0.5f);
  EXPECT_EQ(home["moving_ball_error"], 0) << "the ball lies";
  EXPECT_EQ(home["ball_astray"], 1) << "atan2(0.5, 2) is 14 degrees";
  EXPECT_FLOAT_EQ(home["pose_error"].get<float>(), 0.25f);
  EXPECT_EQ(home["down"], 0);
  EXPECT_EQ(away["ball_error"], 0) << "the other robot sees no ball";
}

TEST(Census, CountsRobotsOnTheGround) {
  State state = known_state();
  state.world.bodies[robot_of(Side::away, 1)].doing = Body::Doing::fallen;
  Census census;
  show_step(census, state);
  EXPECT_EQ(census.of(Side::away)["down"], 1);
  EXPECT_EQ(census.of(Side::home)["down"], 0);
}

TEST(Census, LooksOnlyWhileTheBallIsInPlay) {
  State state = known_state();
  state.book.phase = agent::Game::Phase::set;
  state.robots[robot_of(Side::home, 1)].beliefs.pose.pose.position = {2, 0};
  Census census;
  show_step(census, state);
  EXPECT_EQ(census.of(Side::home)["pose_error"], 0);
}

TEST(Census, WeighsATurnByItsTicks) {
  Average average;
  EXPECT_EQ(average.mean(), 0);
  average.add(1, 3);
  average.add(5);
  EXPECT_EQ(average.mean(), 2);
}

}  // namespace
}  // namespace sim::report
