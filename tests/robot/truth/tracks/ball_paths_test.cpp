#include "robot/truth/tracks/ball_paths.h"

#include <gtest/gtest.h>

#include "robot/truth/tracks/motion.h"
#include "tests/robot/truth/tracks/images.h"
#include "tests/support/truth_game.h"

namespace robot::truth {
namespace {

constexpr double kBallInterval = 1. / 30;  // [s]

Measurement ball_at(double x, double y) { return {0, seen_at(x, y, 0.01)}; }

/// Lets a ball roll along x and returns its filter.
BallPaths rolled(double velocity, double friction, int images, test::Random& random) {
  BallPaths paths(ball_at(0, 0), no_errors());
  for (int i = 1; i < images; ++i) {
    const double t = i * kBallInterval;
    paths.advance(ball_at(velocity * t - friction * t * t / 2 + 0.01 * random.normal(), 0.01 * random.normal()),
                  no_errors(), kBallInterval);
  }
  return paths;
}

TEST(BallPaths, OfAConstantDecelerationHaveTheKnownVelocity) {
  for (const double friction : {0.2, kBallFriction, 0.35}) {
    test::Random random(21);
    const double velocity = rolled(1.5, friction, 60, random).mixture().velocity().x();
    EXPECT_NEAR(velocity, 1.5 - friction * 59 * kBallInterval, 0.06) << friction;
  }
}

TEST(BallPaths, FollowAKickWithinTwoImages) {
  for (const double kick : {1., 1.5, 2.5}) {
    test::Random random(22);
    BallPaths paths = rolled(0, 0, 30, random);
    paths.advance(ball_at(kick * kBallInterval, 0), no_errors(), kBallInterval);
    paths.advance(ball_at(2 * kick * kBallInterval, 0), no_errors(), kBallInterval);
    EXPECT_NEAR(paths.mixture().velocity().x(), kick, 0.25 * kick) << kick;
  }
}

TEST(BallPaths, IgnoreOneMeasurementOfSomethingElse) {
  test::Random random(23);
  BallPaths paths = rolled(0, 0, 30, random);
  paths.advance(ball_at(0.3, 0), no_errors(), kBallInterval);
  EXPECT_EQ(paths.paths()[0].event, BallEvent::not_a_ball);
  paths.advance(ball_at(0, 0), no_errors(), kBallInterval);
  EXPECT_EQ(paths.paths()[0].event, BallEvent::rolled);
  EXPECT_NEAR(paths.mixture().position().x(), 0, 0.01);
}

TEST(BallPaths, ExplainPlacesThatAKickReaches) {
  test::Random random(24);
  const BallPaths paths = rolled(0, 0, 30, random);
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
  BallPaths paths = rolled(0, 0, 10, random);
  paths.advance({1, seen_at(0.02, 0, 0.01)}, no_errors(), 0);
  EXPECT_NE(paths.paths()[0].event, BallEvent::kicked);
  EXPECT_TRUE(paths.mixture().covariance.allFinite());
}

}  // namespace
}  // namespace robot::truth
