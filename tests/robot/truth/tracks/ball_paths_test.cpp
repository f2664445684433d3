#include "robot/truth/tracks/ball_paths.h"

#include <gtest/gtest.h>

#include "robot/truth/tracks/motion.h"
#include "tests/robot/truth/tracks/images.h"
#include "tests/support/truth_game.h"

namespace robot::truth {
namespace {

constexpr double kBallInterval = 1. / 30;  // [s]

Measurement ball_at(double x, double y) { return {0, seen_at(x, y, 0.01)}; }

/// Shows a ball at x with noise.
void show(BallPaths& paths, double x, test::Random& random) {
  const Eigen::Vector2d noise = 0.01 * random.normal2();
  paths.advance(ball_at(x + noise.x(), noise.y()), no_errors(), kBallInterval);
}

/// Returns the filter of a ball that lies at the origin.
BallPaths resting(test::Random& random) {
  BallPaths paths(ball_at(0, 0), no_errors());
  for (int i = 0; i < 30; ++i) show(paths, 0, random);
  return paths;
}

TEST(BallPaths, OfAConstantDecelerationHaveTheKnownVelocity) {
  for (const double friction : {0.2, kBallFriction, 0.35}) {
    test::Random random(21);
    BallPaths paths(ball_at(0, 0), no_errors());
    double squares = 0;
    for (int i = 1; i <= 90; ++i) {
      const double time = i * kBallInterval;
      show(paths, 1.5 * time - friction * time * time / 2, random);
      const double error = paths.mixture().velocity().x() - (1.5 - friction * time);
      if (i > 15) squares += error * error / 75;
    }
    EXPECT_LT(std::sqrt(squares), 0.08) << friction;
  }
}

TEST(BallPaths, FollowAKickWithinTwoImages) {
  for (const double kick : {1., 1.5, 2.5}) {
    test::Random random(22);
    BallPaths paths = resting(random);
    paths.advance(ball_at(kick * kBallInterval, 0), no_errors(), kBallInterval);
    paths.advance(ball_at(2 * kick * kBallInterval, 0), no_errors(), kBallInterval);
    EXPECT_NEAR(paths.mixture().velocity().x(), kick, 0.25 * kick) << kick;
  }
}

TEST(BallPaths, IgnoreOneMeasurementOfSomethingElse) {
  test::Random random(23);
  BallPaths paths = resting(random);
  paths.advance(ball_at(0.3, 0), no_errors(), kBallInterval);
  EXPECT_EQ(paths.paths()[0].event, BallEvent::not_a_ball);
  paths.advance(ball_at(0, 0), no_errors(), kBallInterval);
  EXPECT_EQ(paths.paths()[0].event, BallEvent::rolled);
  EXPECT_NEAR(paths.mixture().position().x(), 0, 0.01);
}

TEST(BallPaths, ExplainPlacesThatAKickReaches) {
  test::Random random(24);
  const BallPaths paths = resting(random);
  EXPECT_TRUE(paths.explains(ball_at(0.1, 0), no_errors(), kBallInterval));
  EXPECT_FALSE(paths.explains(ball_at(0.3, 0), no_errors(), kBallInterval));
  EXPECT_TRUE(paths.explains(ball_at(2, 0), no_errors(), 1));
}

TEST(BallPaths, AreBoundedAndInTheOrderOfTheirWeights) {
  test::Random random(25);
  BallPaths paths(ball_at(0, 0), no_errors());
  for (int i = 0; i < 200; ++i) {
    paths.advance(ball_at(random.uniform(0, 0.2), 0), no_errors(), kBallInterval);
    ASSERT_LE(paths.count(), kMostPaths);
    EXPECT_EQ(paths.paths()[0].log_weight, 0);
    for (std::size_t k = 1; k < paths.count(); ++k)
      EXPECT_LE(paths.paths()[k].log_weight, paths.paths()[k - 1].log_weight);
    EXPECT_TRUE(paths.mixture().covariance.allFinite());
  }
}

TEST(BallPaths, OfTwoImagesAtOnceContainNoKick) {
  test::Random random(26);
  BallPaths paths = resting(random);
  paths.advance({1, seen_at(0.02, 0, 0.01)}, no_errors(), 0);
  EXPECT_NE(paths.paths()[0].event, BallEvent::kicked);
  EXPECT_TRUE(paths.mixture().covariance.allFinite());
}

}  // namespace
}  // namespace robot::truth
