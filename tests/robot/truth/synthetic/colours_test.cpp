#include "robot/truth/synthetic/colours.h"

#include <gtest/gtest.h>

namespace robot::truth {
namespace {

constexpr std::size_t kWidth = 200, kHeight = 100;

bool is_orange(const DepthFrame& frame, std::size_t row, std::size_t column) {
  const std::uint8_t* const rgb = &frame.rgb[3 * (row * kWidth + column)];
  return rgb[0] > 200 && rgb[2] < 100;
}

/// The colours of a carpet with an orange board in columns 50 to 149.
DepthFrame painted(std::uint64_t number) {
  Cast cast{std::vector<float>(kWidth * kHeight, 2), std::vector<Material>(kWidth * kHeight, Material::carpet)};
  for (std::size_t i = 0; i < cast.material.size(); ++i)
    if (i % kWidth >= 50 && i % kWidth < 150) cast.material[i] = Material::orange;
  DepthFrame frame;
  frame.intrinsics = {.width = kWidth, .height = kHeight};
  paint(cast, number, frame);
  return frame;
}

int orange_in_column(const DepthFrame& frame, std::size_t column) {
  int count = 0;
  for (std::size_t row = 0; row < kHeight; ++row) count += is_orange(frame, row, column);
  return count;
}

TEST(Colours, AreShiftedByAPixelToTheRight) {
  const DepthFrame frame = painted(1);
  EXPECT_EQ(orange_in_column(frame, 50), 0);
  EXPECT_GT(orange_in_column(frame, 51), 80);
  EXPECT_GT(orange_in_column(frame, 150), 80);
  EXPECT_EQ(orange_in_column(frame, 151), 0);
}

TEST(Colours, OneOrangePixelOf20HasAnotherColour) {
  const DepthFrame frame = painted(1);
  int count = 0;
  for (std::size_t column = 51; column <= 150; ++column) count += orange_in_column(frame, column);
  EXPECT_NEAR(count, 9500, 100);
}

TEST(Colours, DifferentNumbersGiveDifferentFaults) {
  EXPECT_EQ(painted(1).rgb, painted(1).rgb);
  EXPECT_NE(painted(1).rgb, painted(2).rgb);
}

}  // namespace
}  // namespace robot::truth
