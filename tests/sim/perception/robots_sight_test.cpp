#include "sim/perception/robots_sight.h"

#include <gtest/gtest.h>

#include "sim/perception/image.h"
#include "tests/sim/perception/scene.h"

namespace sim::perception {
namespace {

constexpr int kPlayer = Scene::kOpponent - kMaxPlayers;  // as an index of `opponents`

TEST(RobotsSight, OnlyAnOpponentInViewIsSeen) {
  Scene scene;
  scene.effects = {};
  scene.effects.limited_view = true;
  scene.enter();
  scene.stand({-2, 0}, 0, Scene::kOpponent);
  for (int i = 0; i < 100; ++i) scene.perceive();
  for (const agent::Opponent& opponent : scene.beliefs.opponents) EXPECT_EQ(opponent.seen, kNever);

  scene.stand({2, 0.5f}, 0, Scene::kOpponent);
  for (int i = 0; i < 20; ++i) scene.perceive();
  for (int i = 0; i < kMaxPlayers; ++i) EXPECT_EQ(scene.beliefs.opponents[i].seen != kNever, i == kPlayer);
  EXPECT_EQ(scene.beliefs.opponents[kPlayer].position, scene.body(Scene::kOpponent).position);
}

TEST(RobotsSight, EachOpponentHasItsTurn) {
  Scene scene;
  scene.effects = {};
  scene.effects.limited_view = true;
  scene.enter();
  for (int i = 0; i < 4; ++i) scene.stand({2, 0.3f * static_cast<float>(i)}, 0, kMaxPlayers + i);
  for (int i = 0; i < 4 * static_cast<int>(kGlance); ++i) scene.perceive();
  for (int i = 0; i < 4; ++i) EXPECT_NE(scene.beliefs.opponents[i].seen, kNever) << i;

  // a robot that looks less often misses no turn
  scene.beliefs = {};
  for (int i = 0; i < 7; ++i) scene.perceive(3);
  for (int i = 0; i < 4; ++i) EXPECT_NE(scene.beliefs.opponents[i].seen, kNever) << i;

  // each opponent still has its turn when images are rare
  for (Tick steps = 1; steps <= 15; ++steps) {
    scene.beliefs.opponents[0] = scene.beliefs.opponents[3] = {};
    for (Tick i = 0; i < 4 * kGlance; ++i) scene.perceive(steps);
    for (const int i : {0, 3}) EXPECT_NE(scene.beliefs.opponents[i].seen, kNever) << i << ' ' << steps;
  }
}

TEST(RobotsSight, WithoutLimitedViewAllAreSeenInEveryImage) {
  for (const float attacks : {1.f, -1.f}) {
    Scene scene;
    scene.effects = {};
    scene.world.home_attacks = attacks;
    for (int i = 0; i < 4; ++i) scene.stand({-2, static_cast<float>(i)}, 0, kMaxPlayers + i);
    scene.enter();
    scene.perceive();
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(scene.beliefs.opponents[i].seen, scene.world.tick);
      EXPECT_NEAR(distance(scene.beliefs.opponents[i].position, attacks * scene.body(kMaxPlayers + i).position), 0,
                  1e-6f);
    }
  }
}

TEST(RobotsSight, IsPlacedByTheBelievedPose) {
  Scene scene;
  scene.effects = {};
  scene.effects.limited_view = scene.effects.odometry_drift = true;
  scene.marks.count = 0;
  scene.enter();
  scene.beliefs.pose.pose = {{-1, 0.5f}, kPi / 2};
  scene.stand({2, 0}, 0, Scene::kOpponent);
  for (int i = 0; i < 20; ++i) scene.perceive();
  EXPECT_NEAR(distance(scene.beliefs.opponents[kPlayer].position, {-1, 2.5f}), 0, 1e-5f);
}

TEST(RobotsSight, IsDetectedByItsDistanceAndWithNoise) {
  Scene scene(2);
  scene.effects = {};
  scene.effects.limited_view = scene.effects.missed_ball = scene.effects.ball_noise = true;
  scene.enter();
  scene.stand({2, 0}, 0, Scene::kOpponent);
  const int looks = 5000;
  int seen = 0;
  double squares = 0;
  // the first tick in which the opponent's turn comes
  const Look look = scene.look_after(1);
  scene.world.tick = static_cast<Tick>(kPlayer) * kGlance;
  for (int i = 0; i < looks; ++i) {
    scene.beliefs.opponents[kPlayer] = {};
    scene.world.tick += static_cast<Tick>(scene.world.players) * kGlance;
    look_for_opponents(scene.params(), {&look, 1});
    const agent::Opponent& opponent = scene.beliefs.opponents[kPlayer];
    if (opponent.seen == kNever) continue;
    ++seen;
    squares += squared_length(opponent.position - Vec2{2, 0});
  }
  EXPECT_NEAR(static_cast<float>(seen) / looks, probability(scene.model.robots, 2), 0.02f);
  const float variance = percept_variance(image_noise(scene.model, true), 4, scene.model.camera.height);
  EXPECT_NEAR(squares / seen / (2 * variance), 1, 0.25);
}

}  // namespace
}  // namespace sim::perception
