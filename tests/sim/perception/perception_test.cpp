#include "sim/perception/perception.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/perception/scene.h"

namespace sim::perception {
namespace {

/// Walks in a curve past a rolling ball and an opponent; `side` -1 is the mirrored game.
void walk_past(Scene& scene, float side, int ticks) {
  scene.stand({-0.5f, side * -0.2f}, side * 0.2f);
  scene.stand({1.2f, side * 0.7f}, side * -2.f, Scene::kOpponent);
  scene.stand({0.9f, side * -0.1f}, side * 2.f, 3);
  scene.place_ball({1, side * 0.4f});
  scene.world.ball.velocity = {0.3f, side * -0.6f};
  scene.enter();
  for (int i = 0; i < ticks; ++i) {
    scene.walk({0.2f, side * 0.05f}, side * 0.4f);
    scene.look(side * (0.6f - 0.01f * static_cast<float>(i)), 0.1f);
    scene.roll_ball();
    scene.perceive();
  }
}

TEST(Perception, WithoutEffectsTheBeliefIsTheTruth) {
  for (const float attacks : {1.f, -1.f}) {
    Scene scene;
    scene.effects = {};
    scene.world.home_attacks = attacks;
    for (int length = 1; length < 60; ++length) {
      walk_past(scene, 1, length);
      const Body& body = scene.body();
      const agent::Ball& ball = scene.beliefs.ball;
      ASSERT_TRUE(ball.visible);
      ASSERT_EQ(ball.position, turned_back(scene.world.ball.position - body.position, body.facing));
      ASSERT_EQ(ball.velocity, turned_back(scene.world.ball.velocity, body.facing));
      ASSERT_EQ(ball.variance, 0);
      ASSERT_EQ(scene.beliefs.pose.pose.position, attacks * body.position);
      ASSERT_EQ(scene.beliefs.pose.deviation, 0);
    }
  }
}

TEST(Perception, AMirroredWorldIsTheMirroredBeliefToTheBit) {
  const auto mirrored = [](Vec2 a) { return Vec2{a.x, -a.y}; };
  for (int length = 1; length < 90; ++length) {
    Scene left, right;
    left.effects.ball_noise = left.effects.odometry_drift = left.effects.false_balls = false;
    right.effects = left.effects;
    walk_past(left, 1, length);
    walk_past(right, -1, length);
    const agent::Beliefs &a = left.beliefs, &b = right.beliefs;
    ASSERT_EQ(a.ball.visible, b.ball.visible) << length;
    ASSERT_EQ(a.ball.position, mirrored(b.ball.position)) << length;
    ASSERT_EQ(a.ball.velocity, mirrored(b.ball.velocity));
    ASSERT_EQ(a.ball.variance, b.ball.variance);
    ASSERT_EQ(a.ball.heat, b.ball.heat);
    ASSERT_EQ(a.pose.pose.position, mirrored(b.pose.pose.position));
    ASSERT_EQ(a.pose.pose.heading, -b.pose.pose.heading);
    for (int i = 0; i < kMaxPlayers; ++i) {
      ASSERT_EQ(a.opponents[i].seen, b.opponents[i].seen);
      ASSERT_EQ(a.opponents[i].position, mirrored(b.opponents[i].position));
    }
  }
}

TEST(Perception, ThreeTicksAtOnceAreThreeTimesOneTick) {
  // a robot that walks and sees nothing: prediction only
  Scene often(3), once(3);
  for (Scene* scene : {&often, &once}) {
    scene->effects.false_balls = false;
    scene->marks.count = 0;
    scene->model.localisation.translation_noise = scene->model.localisation.rotation_noise = 0;
    scene->model.localisation.rotation_per_metre = 0;
    scene->stand({0, 0}, 0.3f);
    scene->enter();
    scene->beliefs.ball = {
        .position = {1, 1}, .velocity = {0.4f, -0.2f}, .variance = 0.02f, .velocity_variance = 0.1f, .seen = 0};
    scene->place_ball({-3, 0});
  }
  for (int i = 1; i <= 90; ++i) {
    often.walk({0.2f, -0.05f}, 0.5f);
    once.walk({0.2f, -0.05f}, 0.5f);
    often.perceive();
    if (i % 3 == 0) once.perceive(3);
  }
  EXPECT_EQ(often.world.tick, once.world.tick);
  const agent::Ball &a = often.beliefs.ball, &b = once.beliefs.ball;
  EXPECT_NEAR(distance(a.position, b.position), 0, 2e-3f);
  EXPECT_NEAR(distance(a.velocity, b.velocity), 0, 1e-3f);
  EXPECT_NEAR(a.variance, b.variance, 1e-3f);
  EXPECT_EQ(a.frames, b.frames);
  EXPECT_NEAR(distance(often.beliefs.pose.pose.position, once.beliefs.pose.pose.position), 0, 2e-3f);
  EXPECT_NEAR(often.beliefs.pose.pose.heading, once.beliefs.pose.pose.heading, 1e-4f);
  EXPECT_NEAR(often.beliefs.pose.deviation, once.beliefs.pose.deviation, 1e-4f);
}

TEST(Perception, ARobotThatEntersKnowsNothingAboutTheBall) {
  Scene scene;
  scene.perceive();
  scene.enter();
  EXPECT_EQ(scene.beliefs.ball.seen, kNever);
  EXPECT_FALSE(scene.beliefs.ball.visible);
  EXPECT_EQ(std::sqrt(scene.beliefs.ball.variance), scene.model.filter.lost_deviation);
  scene.look(2, 0);
  scene.effects.false_balls = false;
  scene.perceive(30);
  EXPECT_EQ(scene.beliefs.ball.seen, kNever);
  EXPECT_EQ(scene.beliefs.ball.position, Vec2{});
}

TEST(Perception, DoesNotDependOnTheOrderOfRobots) {
  Scene first(5), second(5);
  first.enter();
  second.enter();
  agent::Beliefs others;
  Cognition cognition;
  for (int i = 0; i < 300; ++i) {
    first.perceive();
    const Look other{&second.world, &others, &cognition, 0, 1};
    perceive(second.params(), {&other, 1});
    second.perceive();
    ASSERT_EQ(first.beliefs.ball.position, second.beliefs.ball.position);
    ASSERT_EQ(first.beliefs.pose.pose, second.beliefs.pose.pose);
  }
}

}  // namespace
}  // namespace sim::perception
