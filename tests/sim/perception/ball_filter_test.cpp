#include "sim/perception/ball_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/perception/odometry.h"
#include "tests/sim/perception/scene.h"

namespace sim::perception {
namespace {

/// A robot with a known pose that sees the ball with noise.
Scene watching_scene(std::uint64_t seed) {
  Scene scene(seed);
  scene.effects = {};
  scene.effects.limited_view = scene.effects.ball_noise = true;
  scene.enter();
  return scene;
}

/// Predicts a ball for a robot that stands still.
void predict_ball(Scene& scene, Tick steps, agent::Ball& ball) {
  scene.beliefs.ball = ball;
  const Look look = scene.look_after(steps);
  predict(scene.params(), {&look, 1});
  ball = scene.beliefs.ball;
}

/// Lets the robot take a percept at this place [m, robot] in the next image.
void see_at(Scene& scene, Vec2 place) {
  const BallPercept percept{.seen = true, .position = place, .images = {.count = 1}};
  ++scene.world.tick;
  const Look look = scene.look_after(1);
  update(scene.params(), {&look, 1}, {&percept, 1});
}

float miss_of(const Scene& scene) { return distance(scene.beliefs.ball.position, scene.world.ball.position); }

TEST(BallFilter, UncertaintyGrowsUnseenAndAPerceptReducesIt) {
  Scene scene = watching_scene(1);
  for (int i = 0; i < 30; ++i) scene.perceive();
  const agent::Ball& ball = scene.beliefs.ball;
  const float watched = ball.variance;
  const float most = scene.model.filter.lost_deviation * scene.model.filter.lost_deviation;

  scene.look(2, 0);
  for (float last = watched; ball.variance < most; last = ball.variance) {
    scene.perceive();
    ASSERT_GT(ball.variance, last);
    ASSERT_FALSE(ball.visible);
  }
  scene.perceive(30);
  EXPECT_EQ(ball.variance, most);
  EXPECT_EQ(ball.velocity, Vec2{});

  scene.look(0, 0);
  scene.perceive();
  EXPECT_TRUE(ball.visible);
  EXPECT_EQ(ball.seen, scene.world.tick);
  EXPECT_LT(ball.variance, 0.05f);
}

TEST(BallFilter, ManyShortPredictionsEndWhereOneLongOneDoes) {
  Scene scene = watching_scene(1);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> metres(-3, 3), share(0, 1);
  for (int i = 0; i < 200; ++i) {
    agent::Ball often{.position = {metres(random), metres(random)},
                      .velocity = {0.5f * metres(random), 0.5f * metres(random)},
                      .variance = 0.1f * share(random),
                      .covariance = 0.01f * share(random),
                      .velocity_variance = 0.1f * share(random),
                      .seen = 0};
    agent::Ball once = often;
    for (int step = 0; step < 12; ++step) predict_ball(scene, 1, often);
    predict_ball(scene, 12, once);
    ASSERT_NEAR(distance(often.position, once.position), 0, 1e-4f);
    ASSERT_NEAR(distance(often.velocity, once.velocity), 0, 1e-4f);
    ASSERT_NEAR(often.variance, once.variance, 1e-4f);
    ASSERT_NEAR(often.covariance, once.covariance, 1e-4f);
    ASSERT_NEAR(often.velocity_variance, once.velocity_variance, 1e-4f);
  }
}

TEST(BallFilter, PredictsAsTheBallRolls) {
  Scene scene = watching_scene(1);
  Ball truth;
  truth.velocity = {1, -0.5f};
  agent::Ball ball{.velocity = truth.velocity, .seen = 0};
  for (int i = 0; i < 150; ++i) {
    roll(truth, scene.ball.deceleration, 0, kTickDuration);
    agent::Ball unbounded = ball;
    unbounded.variance = unbounded.covariance = unbounded.velocity_variance = 0;
    predict_ball(scene, 1, unbounded);
    ball = unbounded;
    ASSERT_NEAR(distance(ball.position, truth.position), 0, 1e-3f);
  }
  EXPECT_EQ(ball.velocity, Vec2{});
}

TEST(BallFilter, ARobotThatTurnsAndWalksKeepsTheBallInPlace) {
  Scene scene = watching_scene(4);
  scene.effects.ball_noise = false;
  scene.perceive();
  scene.look(2, 0);
  for (int i = 0; i < 30; ++i) {
    scene.walk({0.2f, 0.1f}, -0.8f);
    scene.perceive();
    const Body& body = scene.body();
    const Vec2 ball = body.position + turned(scene.beliefs.ball.position, body.facing);
    ASSERT_NEAR(distance(ball, scene.world.ball.position), 0, 1e-4f);
  }
  EXPECT_FALSE(scene.beliefs.ball.visible);
}

TEST(BallFilter, ErrorsMatchTheirBelievedVariance) {
  double sum = 0;
  int images = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Scene scene = watching_scene(seed);
    scene.place_ball({0.6f + 0.012f * static_cast<float>(seed), 0.1f});
    for (int i = 0; i < 60; ++i) {
      scene.perceive();
      const float error = miss_of(scene);
      sum += error * error / (2 * scene.beliefs.ball.variance);
      ++images;
    }
  }
  // a ball at rest has smaller errors than a filter for moving balls believes
  EXPECT_GT(sum / images, 0.7);
  EXPECT_LT(sum / images, 1.3);
}

TEST(BallFilter, FindsTheVelocityOfARollingBall) {
  double squares = 0;
  const int games = 100;
  for (std::uint64_t seed = 0; seed < games; ++seed) {
    Scene scene = watching_scene(seed);
    scene.place_ball({1.2f, -0.5f});
    scene.world.ball.velocity = {-0.2f, 0.8f};
    for (int i = 0; i < 24; ++i) {
      scene.roll_ball();
      scene.perceive();
    }
    const float error = distance(scene.beliefs.ball.velocity, scene.world.ball.velocity);
    squares += error * error;
  }
  // 0.8 s of a ball 1 m away, whose percepts have an error of 5 cm
  EXPECT_LT(std::sqrt(squares / games), 0.15);
}

TEST(BallFilter, ImagesTogetherEqualImagesOneByOne) {
  // for a ball that keeps its velocity, with a gate so wide that no percept is doubted
  double variances = 0, covariances = 0, velocity_variances = 0;
  const int looks = 400;
  double one_by_one = 0, together = 0, velocity_one_by_one = 0, velocity_together = 0;
  for (std::uint64_t seed = 0; seed < looks; ++seed) {
    Scene often = watching_scene(seed);
    often.effects.missed_ball = often.effects.false_balls = false;
    often.model.filter.acceleration_noise = 0;
    often.model.filter.reacquire = 100;
    often.place_ball({1, 0.2f});
    often.perceive();
    Scene once = often;
    once.world.key.seed = seed + 1000;
    for (int image = 0; image < 8; ++image) often.perceive();
    once.perceive(8);
    const agent::Ball &a = often.beliefs.ball, &b = once.beliefs.ball;
    variances += static_cast<double>(b.variance / a.variance);
    covariances += static_cast<double>(b.covariance / a.covariance);
    velocity_variances += static_cast<double>(b.velocity_variance / a.velocity_variance);
    one_by_one += squared_length(a.position - Vec2{1, 0.2f});
    together += squared_length(b.position - Vec2{1, 0.2f});
    velocity_one_by_one += squared_length(a.velocity);
    velocity_together += squared_length(b.velocity);
  }
  EXPECT_NEAR(variances / looks, 1, 0.05);
  EXPECT_NEAR(covariances / looks, 1, 0.05);
  EXPECT_NEAR(velocity_variances / looks, 1, 0.05);
  EXPECT_NEAR(together / one_by_one, 1, 0.2);
  EXPECT_NEAR(velocity_together / velocity_one_by_one, 1, 0.2);
}

TEST(BallFilter, OneFalsePerceptDoesNotThrowAGoodTrackAway) {
  Scene scene = watching_scene(5);
  for (int i = 0; i < 30; ++i) scene.perceive();
  agent::Ball& ball = scene.beliefs.ball;
  const Tick seen = ball.seen;
  const Vec2 elsewhere{3, 1.5f};
  see_at(scene, elsewhere);
  EXPECT_LT(miss_of(scene), 0.15f);
  EXPECT_EQ(ball.seen, seen);
  EXPECT_FALSE(ball.visible);
  for (int i = 0; i < 3; ++i) scene.perceive();
  EXPECT_LT(miss_of(scene), 0.2f);
}

TEST(BallFilter, TwoPerceptsElsewhereAreBelieved) {
  Scene scene = watching_scene(6);
  for (int i = 0; i < 30; ++i) scene.perceive();
  agent::Ball& ball = scene.beliefs.ball;
  const Vec2 elsewhere{2, 1};
  for (int i = 0; i < 2; ++i) see_at(scene, elsewhere);
  EXPECT_TRUE(ball.visible);
  EXPECT_LT(distance(ball.position, elsewhere), 0.2f);
}

TEST(BallFilter, AForgottenBallJumpsToItsNextPercept) {
  Scene scene = watching_scene(7);
  for (int i = 0; i < 60; ++i) scene.perceive();
  scene.look(2, 0);
  scene.perceive(ticks(kForgotten));
  agent::Ball& ball = scene.beliefs.ball;
  const Vec2 elsewhere{0.5f, 1.8f};
  see_at(scene, elsewhere);
  EXPECT_TRUE(ball.visible);
  EXPECT_NEAR(distance(ball.position, elsewhere), 0, 1e-6f);
  EXPECT_EQ(ball.velocity, Vec2{});
}

TEST(BallFilter, CountsImagesInARow) {
  Scene scene = watching_scene(8);
  scene.effects.ball_noise = false;
  const agent::Ball& ball = scene.beliefs.ball;
  for (int i = 1; i <= 300; ++i) {
    scene.perceive();
    ASSERT_EQ(ball.frames, std::min(i, 255));
  }
  scene.look(2, 0);
  scene.perceive();
  EXPECT_EQ(ball.frames, 1);
  scene.perceive(3);
  EXPECT_EQ(ball.frames, 4);
  EXPECT_EQ(age(scene.world.tick, ball.seen), 4 * kTickDuration);
}

TEST(BallFilter, HeatCoolsDownUnseen) {
  Scene scene = watching_scene(9);
  scene.effects.ball_noise = false;
  scene.stand({1.2f, 0}, kPi, Scene::kOpponent);
  scene.perceive();
  const agent::Ball& ball = scene.beliefs.ball;
  EXPECT_NEAR(ball.heat, 1, 1e-5f);
  scene.look(2, 0);
  for (int i = 0; i < 60; ++i) {
    const float before = ball.heat;
    scene.perceive();
    ASSERT_LT(ball.heat, before);
  }
  EXPECT_LT(ball.heat, 0.01f);
}

}  // namespace
}  // namespace sim::perception
