#include "robot/truth/detection/ball_plane.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/synthetic/hall.h"

namespace robot::truth {
namespace {

constexpr double kRadius = 0.05;

TEST(BallPlane, ThePlaceOfABallsPixelIsItsPlace) {
  const SensorPose pose = mast(kField2012);
  const BallPlane plane(pose, kRadius);
  for (const auto& [x, y] : {std::pair{0., 0.}, {-1.5, 1.}, {0.7, -1.2}}) {
    const Place place = plane.place(pose.pixel({x, y, kRadius}), 0.2);
    EXPECT_LT((place.position - Eigen::Vector2d(x, y)).norm(), 1e-9);
  }
}

TEST(BallPlane, TheCovarianceIsThatOfThePixel) {
  const SensorPose pose = mast(kField2012);
  const BallPlane plane(pose, kRadius);
  const Eigen::Vector2d pixel = pose.pixel({0, 0, kRadius});
  const Eigen::Matrix2d covariance = plane.place(pixel, 1).covariance;
  const Eigen::Vector2d right = plane.place(pixel + Eigen::Vector2d(1, 0), 1).position;
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), right.x(), 1e-4);
  EXPECT_GT(covariance(1, 1), covariance(0, 0)) << "the range is less certain than the bearing";
}

TEST(BallPlane, APixelAboveTheHorizonHasNoPlace) {
  const BallPlane plane(looking({0, -3, 1}, {0, 0, 1}), kRadius);
  EXPECT_FALSE(plane.centre({320, 239}));
  EXPECT_TRUE(plane.centre({320, 300}));
}

TEST(BallPlane, ABallIsWholeWhenAllOfItIsWithinTheImage) {
  const BallPlane plane(mast(kField2012), kRadius);
  EXPECT_TRUE(plane.whole({10, 10}, 10));
  EXPECT_FALSE(plane.whole({9, 10}, 10));
  EXPECT_TRUE(plane.whole({630, 470}, 10));
  EXPECT_FALSE(plane.whole({630, 471}, 10));
}

}  // namespace
}  // namespace robot::truth
