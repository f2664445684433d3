// The ball in synthetic images, by colour and by shape.
#include <gtest/gtest.h>

#include "tests/robot/truth/detection/watched.h"

namespace robot::truth {
namespace {

Scene ball_at(double x, double y, double radius = 0.05, BallColour colour = BallColour::orange) {
  Scene scene;
  scene.ball = SceneBall{x, y, radius, radius, colour};
  return scene;
}

/// Rolls a ball along a line. Each image must show it within `most` [m].
void roll(Watched& watched, double radius, BallColour colour, double far, double most) {
  double squares = 0;
  int count = 0;
  for (double part = 0; part <= 1; part += 0.1, ++count) {
    const double x = -1 + 2.2 * part, y = -1 + (far + 1) * part;
    const Detections seen = watched.see(ball_at(x, y, radius, colour), static_cast<std::uint64_t>(count));
    ASSERT_TRUE(seen.ball) << x << " " << y;
    EXPECT_LT((seen.ball->place.position - Eigen::Vector2d(x, y)).norm(), most) << x << " " << y;
    squares += normalised_error_squared(seen.ball->place, x, y);
    EXPECT_TRUE(seen.robots.empty());
  }
  EXPECT_GT(squares / count, 0.5) << "the covariance is not too large";
  EXPECT_LT(squares / count, 5) << "the covariance is not too small";
}

TEST(Ball, ThatRollsAlongALineIsFoundOnItByItsColour) {
  Watched watched(mast(kField2012));
  roll(watched, 0.05, BallColour::orange, 1.6, 0.012);
}

TEST(Ball, OfTheSmallSizeIsFoundByItsColour) {
  Watched watched(mast(kField2012), {.ball_radius = 0.0325, .colour_shift_x = 1});
  roll(watched, 0.0325, BallColour::orange, 1.6, 0.012);
}

TEST(Ball, ThatIsBlackAndWhiteIsFoundByItsShape) {
  Watched watched(mast(kField2012), {.orange_ball = false});
  roll(watched, 0.05, BallColour::black_and_white, 1.6, 0.02);
}

TEST(Ball, WithoutColoursIsFoundByItsShape) {
  Watched watched(mast(kField2012), {.ball_radius = 0.0325}, {.colour = false});
  roll(watched, 0.0325, BallColour::orange, 0.6, 0.02);
}

TEST(Ball, OfAnUnknownColourShiftIsOffByThatPixel) {
  Watched watched(mast(kField2012), {.colour_shift_x = 0});
  const Detections seen = watched.see(ball_at(0, 0));
  ASSERT_TRUE(seen.ball);
  const double pixel = 3.4 / 575.8;  // [m] at the ball's range
  EXPECT_NEAR(seen.ball->place.position.x(), pixel, 0.003);
}

TEST(Ball, BehindARobotIsMissing) {
  Watched watched;
  Scene scene = ball_at(0, 0.15);
  scene.robots = {{.x = 0, .y = 0}};
  EXPECT_FALSE(watched.see(scene).ball);
}

TEST(Ball, AtARobotsFeetIsFoundByItsColour) {
  Watched watched;
  Scene scene = ball_at(0.05, -0.17);
  scene.robots = {{.x = 0, .y = 0, .heading = -1.57}};
  const Detections seen = watched.see(scene);
  ASSERT_TRUE(seen.ball);
  EXPECT_LT((seen.ball->place.position - Eigen::Vector2d(0.05, -0.17)).norm(), 0.012);
}

TEST(Ball, ThatIsMuchLargerOrInTheAirIsNone) {
  Watched watched;
  EXPECT_FALSE(watched.see(ball_at(0, 0, 0.15)).ball);
  Scene scene = ball_at(0, 0);
  scene.ball->z = 0.6;
  EXPECT_FALSE(watched.see(scene).ball);
}

TEST(Ball, IsNotSeenWhereNoneIs) {
  Watched by_colour, by_shape(mast(kField2012), {.orange_ball = false});
  const Scene scene{.robots = {{.x = -0.5, .y = 0.4}, {.x = 0.8, .y = 0.9, .heading = 2}},
                    .people = {{.x = 0.3, .y = 1.9, .heading = 1, .stride = 0.3}}};
  for (std::uint64_t number = 0; number < 5; ++number) {
    EXPECT_FALSE(by_colour.see(scene, number).ball) << number;
    EXPECT_FALSE(by_shape.see(scene, number).ball) << number;
  }
}

}  // namespace
}  // namespace robot::truth
