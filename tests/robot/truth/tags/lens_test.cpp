#include "robot/truth/tags/lens.h"

#include <gtest/gtest.h>

namespace {

using robot::truth::tags::Lens;

const robot::truth::Intrinsics kWide{
    .width = 1280, .height = 720, .focal_x = 700, .focal_y = 710, .centre_x = 640, .centre_y = 360, .baseline = 0};

TEST(Lens, WithoutDistortionIsAPinhole) {
  const Lens lens{.intrinsics = kWide};
  EXPECT_TRUE(lens.ray({640, 360}).isApprox(Eigen::Vector3d(0, 0, 1)));
  EXPECT_TRUE(lens.pixel({0.5, -0.25, 2}).isApprox(Eigen::Vector2d(640 + 175, 360 - 88.75)));
}

TEST(Lens, KnownAnswersOfBrownAndConrady) {
  const Lens radial{.intrinsics = kWide, .k1 = -0.1, .k2 = 0.02};
  EXPECT_NEAR(radial.pixel({1, 0, 1}).x(), 640 + 700 * 0.92, 1e-9);
  const Lens tilted{.intrinsics = kWide, .p1 = 0.01, .p2 = 0.002};
  // x + 2 p1 x y + p2 (r² + 2 x²), y + p1 (r² + 2 y²) + 2 p2 x y
  EXPECT_NEAR(tilted.pixel({1, 1, 1}).x(), 640 + 700 * (1 + 0.02 + 0.008), 1e-9);
  EXPECT_NEAR(tilted.pixel({1, 1, 1}).y(), 360 + 710 * (1 + 0.04 + 0.004), 1e-9);
}

TEST(Lens, RayAndPixelAreInverse) {
  const Lens lens{.intrinsics = kWide, .k1 = -0.2, .k2 = 0.05, .p1 = 0.001, .p2 = -0.002};
  for (double x = 0; x <= 1280; x += 80)
    for (double y = 0; y <= 720; y += 80) {
      const Eigen::Vector2d pixel(x, y);
      EXPECT_LT((lens.pixel(3 * lens.ray(pixel)) - pixel).norm(), 1e-6) << x << ", " << y;
    }
}

}  // namespace
