#include "robot/truth/tags/ball_colour.h"

#include <gtest/gtest.h>

#include "tests/support/camera_above.h"
#include "tests/support/rendered_pictures.h"

namespace {

using robot::truth::DepthFrame;
using robot::truth::SeenBall;
using robot::truth::tags::BallLook;
using robot::truth::tags::Camera;
using robot::truth::tags::find_ball;
using tests::Light;
using tests::Things;

constexpr double kRadius = 0.0325;
const Light kOrange{0.75f, 0.2f, 0.02f};

Camera watching_camera() { return tests::camera_above({-1, 0, 2.2}, {0, 0}, {640, 360}, 400); }

std::unique_ptr<tests::Thing> ball_at(double x, double y, double radius = kRadius, const Light& light = kOrange) {
  return tests::sphere({x, y, radius}, radius, light);
}

DepthFrame picture_of(const Things& things) {
  static const tests::Renderer renderer(watching_camera());
  return renderer.render(things, {.noise = 2});
}

std::optional<SeenBall> seen(const Things& things, const BallLook& look = {}) {
  return find_ball(picture_of(things), watching_camera(), look);
}

TEST(BallColour, FindsTheBallWhereItLies) {
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {0.4, 0.6}, {0.9, -0.7}, {-0.5, 0.3}}) {
    Things things;
    things.push_back(ball_at(x, y));
    const auto ball = seen(things);
    ASSERT_TRUE(ball) << x << ", " << y;
    EXPECT_LT((ball->place.position - Eigen::Vector2d(x, y)).norm(), 0.005) << x << ", " << y;
    EXPECT_LT(ball->place.covariance.trace(), 1e-4);
  }
}

TEST(BallColour, TheMirroredSceneGivesTheMirroredPlace) {
  Things one, other;
  one.push_back(ball_at(0.4, 0.6));
  other.push_back(ball_at(0.4, -0.6));
  const auto left = seen(one), right = seen(other);
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(left->place.position.x(), right->place.position.x(), 0.004);
  EXPECT_NEAR(left->place.position.y(), -right->place.position.y(), 0.004);
}

TEST(BallColour, APartlyHiddenBallHasAGreaterDeviation) {
  Things whole, part;
  whole.push_back(ball_at(0.2, 0.1));
  part.push_back(ball_at(0.2, 0.1));
  part.push_back(tests::cylinder({0.13, 0.08}, 0.035, 0.1, {0.5f, 0.5f, 0.5f}));
  const auto all = seen(whole), some = seen(part);
  ASSERT_TRUE(all && some);
  EXPECT_GT(some->place.covariance.trace(), 2 * all->place.covariance.trace());
  EXPECT_LT((some->place.position - Eigen::Vector2d(0.2, 0.1)).norm(), kRadius);
}

TEST(BallColour, OtherThingsAreNoBall) {
  EXPECT_FALSE(seen({}));
  Things things;
  things.push_back(ball_at(0.3, 0.3, 0.08));                            // too large
  things.push_back(ball_at(-0.3, 0.3, 0.015));                          // too small
  things.push_back(ball_at(0.3, -0.3, kRadius, {0.1f, 0.2f, 0.8f}));    // blue
  things.push_back(tests::cylinder({-0.3, -0.5}, 0.03, 0.3, kOrange));  // too long
  EXPECT_FALSE(seen(things));
  things.push_back(ball_at(0, 0));
  const auto ball = seen(things);
  ASSERT_TRUE(ball);
  EXPECT_LT(ball->place.position.norm(), 0.005);
}

TEST(BallColour, ARangeOfHuesMayGoOverZero) {
  Things things;
  things.push_back(ball_at(0, 0, kRadius, {0.7f, 0.02f, 0.05f}));  // red, hue about 350
  BallLook look;
  EXPECT_FALSE(seen(things, look));
  look.colours.hue_from_deg = 330;
  look.colours.hue_to_deg = 20;
  EXPECT_TRUE(seen(things, look));
}

TEST(BallColour, APictureOfOneColourHasNoBall) {
  DepthFrame picture = tests::black_picture({640, 360});
  EXPECT_FALSE(find_ball(picture, watching_camera(), {}));
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) picture.rgb[i] = 255, picture.rgb[i + 1] = 128;
  EXPECT_FALSE(find_ball(picture, watching_camera(), {}));
}

}  // namespace
