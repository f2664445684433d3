#include "sim/agent/manners.h"

#include <gtest/gtest.h>

#include "sim/agent/place_skills.h"
#include "tests/sim/agent/scene.h"

namespace sim::agent {
namespace {

using Body = motion::Command::Body;

TEST(Manners, AtTheOpponentsKickNoRobotKicksOrGoesNearTheBall) {
  for (const char* name : kShipped) {
    const TreeBehaviour behaviour(shipped(name));
    std::mt19937 random(1);
    for (int n = 0; n < 3000; ++n) {
      Scene scene = random_scene(random);
      scene.game.set_play = n % 2 ? Game::SetPlay::kick_in : Game::SetPlay::kick_off;
      scene.game.own_kick = false;
      const View view = scene.view();
      if (!view.ball_known) continue;
      const motion::Command command = scene.decide(behaviour);
      EXPECT_NE(command.body, Body::kick);
      // a robot inside leaves, a robot outside does not cut through
      if (command.body != Body::walk_to) {
        EXPECT_GE(view.ball_distance, 0.75f) << n;
        continue;
      }
      const float ahead = std::min(1.f, 0.1f / (length(command.walk) + 1e-6f));
      const float soon = distance(ahead * command.walk, view.ball);
      EXPECT_GE(soon, std::min(0.75f, view.ball_distance - 0.02f)) << n;
    }
  }
}

TEST(Manners, AtTheOpponentsCornerKickPlacesAreInTheField) {
  const field::Field& field = surroundings().rules->field;
  const Vec2 corner{-0.5f * field.length, 0.5f * field.width};
  std::mt19937 random(4);
  std::uniform_real_distribution<float> off(-1.2f, 1.2f), into(0, 1.2f);
  for (int n = 0; n < 500; ++n) {
    Scene scene;
    scene.game.set_play = Game::SetPlay::corner_kick;
    scene.game.own_kick = false;
    scene.game.since_phase = 2;
    // the wanted place is anywhere near the ball, also beyond the lines
    scene.beliefs.pose.pose.position = corner + Vec2{into(random), -into(random)};
    scene.see_ball(scene.view().to_robot(corner));
    const View view = scene.view();
    motion::Command command;
    command.body = Body::walk_to;
    command.walk = view.to_robot(corner + Vec2{off(random), off(random)});
    const bool needs_place = view.ball_distance < 0.75f || distance(command.walk, view.ball) < 0.75f;
    mind_manners(view, command);
    const Vec2 place = view.to_team(command.walk);
    const float beyond = needs_place ? field.border : 1.2f;
    EXPECT_LT(std::abs(place.x), 0.5f * field.length + beyond) << n;
    EXPECT_LT(std::abs(place.y), 0.5f * field.width + beyond) << n;
  }
}

TEST(Manners, RulesThatAskForMoreRoomThanTheHabitAreKept) {
  field::Rules rules = *surroundings().rules;
  rules.clear_distance = 1.5f;
  const Surroundings wide{&rules, surroundings().motion};
  Scene scene;
  scene.game.set_play = Game::SetPlay::kick_in;
  scene.game.own_kick = false;
  scene.game.since_phase = 2;
  scene.see_ball({1.2f, 0});
  const View view(wide, scene.settings, scene.game, scene.beliefs, scene.now, scene.mind);
  motion::Command command;
  command.body = Body::kick;
  mind_manners(view, command);
  ASSERT_EQ(command.body, Body::walk_to);
  EXPECT_GE(distance(command.walk, view.ball), 1.5f) << "away from the ball";
}

TEST(Manners, OnlyTheKeeperWalksIntoTheOwnGoalArea) {
  const TreeBehaviour behaviour(shipped("baseline"));
  std::mt19937 random(2);
  int diverted = 0;
  for (int n = 0; n < 5000; ++n) {
    Scene scene = random_scene(random);
    if (scene.game.player == 1) continue;
    scene.game.set_play = Game::SetPlay::none;
    scene.see_ball(scene.view().to_robot({-2.8f, 0.3f}));
    const motion::Command command = scene.decide(behaviour);
    if (command.body != Body::walk_to) continue;
    const Vec2 place = scene.view().to_team(command.walk);
    const field::Field& field = surroundings().rules->field;
    EXPECT_FALSE(place.x < -0.5f * field.length + field.goal_area_length &&
                 std::abs(place.y) < 0.5f * field.goal_area_width);
    ++diverted;
  }
  EXPECT_GT(diverted, 100);
}

TEST(Manners, TheOwnGoalAreaIsOpenWhereTheRulesHaveNoIllegalDefender) {
  field::Rules rules = *surroundings().rules;
  ASSERT_TRUE(rules.illegal_defender);
  for (const bool illegal : {true, false}) {
    rules.illegal_defender = illegal;
    const Surroundings around{&rules, surroundings().motion};
    Scene scene;
    scene.game.player = 2;
    const View view(around, scene.settings, scene.game, scene.beliefs, scene.now, scene.mind);
    // behind the ball of a goal kick
    const Vec2 place{-0.5f * rules.field.length + rules.field.goal_area_length - 0.2f, 0.5f};
    motion::Command command;
    command.body = Body::walk_to;
    command.walk = view.to_robot(place);
    mind_manners(view, command);
    EXPECT_EQ(distance(view.to_team(command.walk), place) < 1e-4f, !illegal);
  }
}

TEST(Manners, PlacesOfTheKickOffAreInTheOwnHalfAndApart) {
  for (const bool ours : {true, false})
    for (int players = 1; players <= kMaxPlayers; ++players) {
      Scene scene;
      scene.game.own_kick = ours;
      scene.game.players = static_cast<std::uint8_t>(players);
      std::vector<Vec2> places;
      for (int player = 1; player <= players; ++player) {
        scene.game.player = static_cast<std::uint8_t>(player);
        const Vec2 place = ready_place(scene.view());
        EXPECT_LE(place.x, -0.2f);
        EXPECT_GE(place.x, -scene.view().half_length);
        EXPECT_LE(std::abs(place.y), scene.view().half_width);
        EXPECT_TRUE((ours && player == 2) || length(place) > surroundings().rules->field.centre_circle_radius + 0.2f)
            << player;
        for (const Vec2 other : places) EXPECT_GT(distance(place, other), 0.5f) << players << " " << player;
        places.push_back(place);
      }
    }
}

}  // namespace
}  // namespace sim::agent
