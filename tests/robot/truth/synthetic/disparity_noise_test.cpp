#include "robot/truth/synthetic/disparity_noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot/truth/synthetic/hall.h"

namespace robot::truth {
namespace {

/// A wall that fills a Kinect's image.
Cast wall_at(float z) { return {std::vector<float>(640 * 480, z), std::vector<Material>(640 * 480, Material::wall)}; }

DepthFrame measured(const Cast& cast, const Intrinsics& intrinsics = {}, double depth_scale = 1) {
  static const DisparityNoise noise;
  DepthFrame frame;
  frame.intrinsics = intrinsics;
  noise.measure(cast, depth_scale, 3, frame);
  return frame;
}

struct Statistics {
  double mean = 0, deviation = 0, neighbours = 0;  // [m], [m], the correlation of neighbours in a row
  double measured = 0;                             // part of all pixels
};

Statistics statistics_of(const DepthFrame& frame) {
  double count = 0, sum = 0, squares = 0, pairs = 0, products = 0;
  for (const std::uint16_t depth : frame.depth)
    if (depth != 0) ++count, sum += depth * frame.unit, squares += depth * frame.unit * depth * frame.unit;
  const double mean = sum / count, variance = squares / count - mean * mean;
  for (std::size_t i = 1; i < frame.depth.size(); ++i)
    if (frame.depth[i] != 0 && frame.depth[i - 1] != 0)
      ++pairs, products += (frame.depth[i] * frame.unit - mean) * (frame.depth[i - 1] * frame.unit - mean);
  return {mean, std::sqrt(variance), products / pairs / variance, count / static_cast<double>(frame.depth.size())};
}

TEST(DisparityNoise, IsThatOfTheModelWithRoundingAtAnyRange) {
  for (const float z : {1.F, 2.F, 3.F, 5.F}) {
    const Statistics found = statistics_of(measured(wall_at(z)));
    const double expected = std::hypot(DepthNoise::deviation(static_cast<double>(z)),
                                       DepthNoise::step({}, static_cast<double>(z)) / std::sqrt(12.));
    EXPECT_NEAR(found.deviation / expected, 1, 0.15) << z;
    EXPECT_NEAR(found.mean, static_cast<double>(z), 0.01) << z;
  }
}

TEST(DisparityNoise, DepthsAreRoundedToEighthsOfAPixelOfDisparity) {
  const DepthFrame frame = measured(wall_at(4));
  for (std::size_t i = 0; i < frame.depth.size(); i += 101) {
    if (frame.depth[i] == 0) continue;
    const double eighths = 8 * frame.intrinsics.focal_x * frame.intrinsics.baseline / (frame.depth[i] * frame.unit);
    EXPECT_NEAR(eighths, std::round(eighths), 0.02);
  }
}

TEST(DisparityNoise, NeighboursAreAlike) {
  EXPECT_NEAR(statistics_of(measured(wall_at(5))).neighbours, 2. / 3 * 0.8, 0.12);
}

TEST(DisparityNoise, OnePixelOf50IsLostAndMoreBeyond4Metres) {
  EXPECT_NEAR(statistics_of(measured(wall_at(3))).measured, 0.98, 0.002);
  EXPECT_NEAR(statistics_of(measured(wall_at(6))).measured, 0.94, 0.002);
}

TEST(DisparityNoise, NothingIsMeasuredBelowHalfAMetreAndBeyond8Metres) {
  for (const float z : {0.4F, 8.1F, kFar}) {
    const DepthFrame frame = measured(wall_at(z));
    EXPECT_EQ(std::count(frame.depth.begin(), frame.depth.end(), 0), 640 * 480) << z;
  }
}

/// A board at 2 m in columns 200 to 299, before a wall at 4 m.
Cast board() {
  Cast cast = wall_at(4);
  for (std::size_t i = 0; i < cast.depth.size(); ++i)
    if (i % 640 >= 200 && i % 640 < 300) cast.depth[i] = 2;
  return cast;
}

int measured_in_column(const DepthFrame& frame, std::size_t column) {
  int count = 0;
  for (std::size_t row = 0; row < 480; ++row) count += frame.depth[row * 640 + column] != 0;
  return count;
}

TEST(DisparityNoise, TheProjectorCastsAShadowToTheRight) {
  const DepthFrame frame = measured(board());
  // the shadow is as wide as the difference of disparities: 575.8 px * 0.075 m * (1/2 - 1/4)/m = 10.8 px
  for (std::size_t column = 300; column < 310; ++column) EXPECT_EQ(measured_in_column(frame, column), 0) << column;
  EXPECT_GT(measured_in_column(frame, 313), 450);
  EXPECT_GT(measured_in_column(frame, 195), 450);
}

TEST(DisparityNoise, EdgesLoseTwoPixelsOf5) { EXPECT_NEAR(measured_in_column(measured(board()), 200), 0.6 * 480, 50); }

TEST(DisparityNoise, ASensorWithoutBaselineHasNoShadowAndNoSteps) {
  const Intrinsics time_of_flight{.baseline = 0};
  EXPECT_GT(measured_in_column(measured(board(), time_of_flight), 305), 450);
  EXPECT_NEAR(statistics_of(measured(wall_at(5), time_of_flight)).deviation, DepthNoise::deviation(5), 0.003);
}

TEST(DisparityNoise, TheScaleShortensTheMeasuredDepths) {
  EXPECT_NEAR(statistics_of(measured(wall_at(3), {}, 1.02)).mean, 3 / 1.02, 0.002);
}

}  // namespace
}  // namespace robot::truth
