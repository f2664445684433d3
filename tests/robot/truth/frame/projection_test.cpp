#include "robot/truth/frame/projection.h"

#include <gtest/gtest.h>

namespace robot::truth {
namespace {

constexpr Lens kBarrel{.k1 = -0.28, .k2 = 0.07, .k3 = -0.005, .p1 = 0.001, .p2 = -0.0006};

TEST(Lens, WithoutDistortionChangesNothing) {
  EXPECT_EQ(distort({}, {0.3, -0.7}), Eigen::Vector2d(0.3, -0.7));
  EXPECT_EQ(*undistort({}, {0.3, -0.7}), Eigen::Vector2d(0.3, -0.7));
}

TEST(Lens, BendsAsBrownAndConradySay) {
  EXPECT_TRUE(distort({.k1 = -0.1}, {0.5, 0}).isApprox(Eigen::Vector2d(0.4875, 0)));
  EXPECT_TRUE(distort({.k2 = 0.2}, {0, 0.5}).isApprox(Eigen::Vector2d(0, 0.50625)));
  EXPECT_TRUE(distort({.k3 = 1}, {0.5, 0}).isApprox(Eigen::Vector2d(0.5078125, 0)));
  EXPECT_TRUE(distort({.p1 = 0.01}, {0.5, 1}).isApprox(Eigen::Vector2d(0.51, 1.0325)));
  EXPECT_TRUE(distort({.p2 = 0.01}, {0.5, 1}).isApprox(Eigen::Vector2d(0.5175, 1.01)));
}

TEST(Lens, UndistortsWhatItDistorts) {
  for (const Lens& lens : {kBarrel, Lens{.k1 = 0.2, .p2 = 0.002}})
    for (double x = -0.8; x <= 0.8; x += 0.2)
      for (double y = -0.6; y <= 0.6; y += 0.2) {
        const auto straight = undistort(lens, distort(lens, {x, y}));
        ASSERT_TRUE(straight) << x << " " << y;
        EXPECT_NEAR((*straight - Eigen::Vector2d(x, y)).norm(), 0, 1e-10);
      }
}

TEST(Lens, HasNoRayBeyondItsGreatestRadius) {
  const Lens lens{.k1 = -0.3};  // the greatest radius is 0.70, of the ray at 1.05
  EXPECT_TRUE(undistort(lens, {0.69, 0}));
  EXPECT_FALSE(undistort(lens, {0.71, 0}));
  EXPECT_FALSE(undistort(lens, {1e6, -1e6}));
}

TEST(Projection, HasARayForEachPixelAndThePixelForEachRay) {
  const Projection camera{{.focal_x = 500, .focal_y = 510, .centre_x = 310, .centre_y = 250}, kBarrel};
  for (double x = 0; x <= 640; x += 80)
    for (double y = 0; y <= 480; y += 80) {
      const auto ray = camera.ray({x, y});
      ASSERT_TRUE(ray);
      EXPECT_EQ(ray->z(), 1);
      EXPECT_NEAR((camera.pixel(3 * *ray) - Eigen::Vector2d(x, y)).norm(), 0, 1e-7);
      EXPECT_TRUE(camera.shows(3 * *camera.ray({0.99 * x + 1, 0.99 * y + 1})));
    }
}

TEST(Projection, WithoutALensIsAPinhole) {
  const Projection camera{{.focal_x = 700, .focal_y = 710, .centre_x = 640, .centre_y = 360}, {}};
  EXPECT_TRUE(camera.ray({640, 360})->isApprox(Eigen::Vector3d(0, 0, 1)));
  EXPECT_TRUE(camera.pixel({0.5, -0.25, 2}).isApprox(Eigen::Vector2d(640 + 175, 360 - 88.75)));
}

TEST(Projection, ShowsNothingBehindItNorBesideThePicture) {
  const Projection straight{{}, {}};
  EXPECT_TRUE(straight.shows({0, 0, 1}));
  EXPECT_FALSE(straight.shows({0, 0, -1}));
  EXPECT_FALSE(straight.shows({0.6, 0, 1}));
  // the model brings this ray back into the picture, the lens does not
  const Projection folded{{}, {.k1 = -0.3}};
  EXPECT_FALSE(folded.shows({1.7, 0, 1}));
}

}  // namespace
}  // namespace robot::truth
