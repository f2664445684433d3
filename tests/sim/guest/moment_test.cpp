#include "sim/guest/moment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/agent/scene.h"

namespace sim::guest {
namespace {

TEST(Moment, HasTheRobotsBeliefs) {
  agent::Scene scene;  // of player 2
  scene.see_ball({1, 0.5f});
  scene.hear(3, {1.5f, -1}, 4, agent::Role::defender);
  scene.see_opponent(4, {2, 1});
  const ForesightMoment moment = moment_of(scene.game, scene.beliefs, scene.now, true);
  EXPECT_EQ(moment.phase, FORESIGHT_PLAYING);
  EXPECT_TRUE(moment.entered);
  EXPECT_EQ(moment.ball_x, 1);
  EXPECT_EQ(moment.ball_y, 0.5f);
  // by number: player 3 is the third, the own entry is never heard
  EXPECT_EQ(moment.mates[2].x, 1.5f);
  EXPECT_EQ(moment.mates[2].role, FORESIGHT_DEFENDER);
  EXPECT_EQ(moment.mates[1].sent, FORESIGHT_NEVER);
  EXPECT_EQ(moment.opponents[3].x, 2);
  EXPECT_EQ(moment.opponents[0].seen, FORESIGHT_NEVER);
}

TEST(Moment, TheUsualCommandIsThatOfTreesOutsidePlay) {
  for (const auto phase : {agent::Game::Phase::initial, agent::Game::Phase::ready, agent::Game::Phase::set}) {
    agent::Scene scene;
    scene.game.phase = phase;
    scene.see_ball({1, 0.5f});
    agent::Mind mind = scene.mind, other = scene.mind;
    const agent::Settings settings;
    const agent::View view(agent::surroundings(), settings, scene.game, scene.beliefs, scene.now, other);
    EXPECT_EQ(command_of(usual_command(mind), agent::surroundings(), scene.game, scene.beliefs, scene.now, mind),
              agent::wait(view, other, nullptr));
  }
}

TEST(Moment, ACommandIsConverted) {
  agent::Scene scene;
  ForesightCommand told = usual_command(scene.mind);
  told.body = FORESIGHT_KICK, told.kick = 1, told.kick_left = 1, told.gain = 0.5f;
  told.head = FORESIGHT_LOOK_ANGLES, told.look[0] = 0.3f;
  told.role = FORESIGHT_CHASER, told.time_to_ball = 2;
  const motion::Command command =
      command_of(told, agent::surroundings(), scene.game, scene.beliefs, scene.now, scene.mind);
  EXPECT_EQ(command.body, motion::Command::Body::kick);
  EXPECT_EQ(command.kick, 1);
  EXPECT_TRUE(command.kick_left);
  EXPECT_EQ(command.gain, 0.5f);
  EXPECT_EQ(command.head, motion::Command::Head::angles);
  EXPECT_EQ(command.look[0], 0.3f);
  EXPECT_EQ(scene.mind.role, agent::Role::chaser);
  EXPECT_EQ(scene.mind.time_to_ball(), 2);
}

TEST(Moment, ACommandOutsideItsRangeIsASentence) {
  const auto problem = [](auto&& change) {
    ForesightCommand command = usual_command({});
    change(command);
    return problem_of(command, 5);
  };
  EXPECT_EQ(problem([](ForesightCommand&) {}), "");
  EXPECT_EQ(problem([](ForesightCommand& command) { command.body = 9; }), "body must be 0 .. 5, got 9");
  EXPECT_EQ(problem([](ForesightCommand& command) { command.x = NAN; }).substr(0, 25), "x must be -100 .. 100, go");
  EXPECT_EQ(problem([](ForesightCommand& command) { command.body = FORESIGHT_KICK, command.kick = 5; }),
            "kick must be 0 .. 4, got 5");
  EXPECT_EQ(problem([](ForesightCommand& command) { command.gain = 1.5f; }), "gain must be 0 .. 1, got 1.5");
}

}  // namespace
}  // namespace sim::guest
