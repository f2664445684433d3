#include "robot/foresight/believed_situation.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "sim/io/situation.h"
#include "tests/robot/bridge/played.h"

namespace robot::foreseeing {
namespace {

TEST(BelievedSituation, BallAndRobotsAreWhereTheRobotBelievesThemToBe) {
  const bridge::test::Played game;
  const auto text = believed_situation(game.recollection(), game.setup.params, "a belief");
  ASSERT_TRUE(text) << text.error();
  const auto json = nlohmann::json::parse(*text);
  EXPECT_EQ(json["about"], "a belief");
  EXPECT_EQ(json["teams"], (nlohmann::json{{"home", 14}, {"away", 5}}));
  const auto state = sim::io::parse_situation(*text, "situation", game.setup.params);
  ASSERT_TRUE(state) << state.error();
  const sim::World &read = state->world, &truth = game.state.world;
  const int own = sim::robot_of(sim::Side::home, 2);
  const sim::Pose2& believed = game.state.robots[own].beliefs.pose.pose;
  EXPECT_NEAR(sim::distance(read.bodies[own].position, truth.home_attacks * believed.position), 0, 0.01);
  EXPECT_EQ(state->book.score[0], game.state.book.score[0]);
  EXPECT_NEAR(static_cast<double>(state->book.clock), static_cast<double>(game.state.book.clock), 30);
  for (const auto& robot : json["robots"]) EXPECT_TRUE(robot.contains("deviation")) << robot.dump();
}

TEST(BelievedSituation, WithoutABeliefThereIsASentence) {
  const bridge::test::Played game;
  bridge::Recollection lost = game.recollection();
  lost.pose.reset();
  const auto none = believed_situation(lost, game.setup.params, "");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error(), "the robot does not know where it is: there is no object pose yet");
  bridge::Recollection blind = game.recollection();
  blind.ball.reset(), blind.team.reset();
  const auto unseen = believed_situation(blind, game.setup.params, "");
  ASSERT_FALSE(unseen);
  EXPECT_EQ(unseen.error(), "nobody has seen the ball yet");
}

}  // namespace
}  // namespace robot::foreseeing
