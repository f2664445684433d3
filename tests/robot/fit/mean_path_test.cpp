#include "robot/fit/mean_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::fit {
namespace {

lab::Path straight_path() {
  lab::Path path;
  for (int i = 0; i < 90; ++i)
    path.push_back({.at = i / 30., .x = 0.3 * i / 30., .y = 1 - 0.1 * i / 30., .heading = 3.14 + 0.01 * (i % 3)});
  return path;
}

TEST(MeanPath, TheMeanOverAClosedInterval) {
  const MeanPath path(straight_path());
  const auto mean = path.over(1, 2);
  ASSERT_TRUE(mean);
  EXPECT_EQ(mean->places, 31u);
  EXPECT_NEAR(mean->at, 1.5, 1e-9);
  EXPECT_NEAR(mean->x, 0.45, 1e-9);
  EXPECT_NEAR(mean->y, 0.85, 1e-9);
  EXPECT_NEAR(std::remainder(mean->heading - 3.15, 2 * M_PI), 0, 0.01) << "headings are averaged as directions";
  EXPECT_FALSE(path.over(3.5, 4)) << "no place";
  EXPECT_FALSE(MeanPath({}).over(0, 1));
}

TEST(MeanPath, TheSlopeIsTheVelocity) {
  const MeanPath path(straight_path());
  const auto slope = path.slope_over(0.5, 1.5);
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->x, 0.3, 1e-9);
  EXPECT_NEAR(slope->y, -0.1, 1e-9);
  EXPECT_NEAR(slope->deviation, std::sqrt(12. / 31), 0.06);
  EXPECT_FALSE(path.slope_over(0.51, 0.59)) << "fewer than four places";
}

TEST(MeanPath, ImpossiblePlacesAreLeftOutAndCounted) {
  lab::Path damaged = straight_path();
  damaged[40].x = NAN, damaged[41].y = 1e9, damaged[42].at = INFINITY;
  const MeanPath path(damaged);
  EXPECT_EQ(path.left_out(), 3u);
  EXPECT_EQ(path.over(1, 2)->places, 28u);
  EXPECT_NEAR(path.slope_over(1, 2)->x, 0.3, 1e-9);
}

TEST(MeanPath, WithoutHeadingsTheMeanHasNoHeading) {
  lab::Path path = straight_path();
  for (lab::PlaceAt& place : path) place.heading = NAN;
  EXPECT_TRUE(std::isnan(MeanPath(path).over(1, 2)->heading));
}

}  // namespace
}  // namespace robot::fit
