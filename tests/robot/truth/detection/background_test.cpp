#include "robot/truth/detection/background.h"

#include <gtest/gtest.h>

namespace robot::truth {
namespace {

TEST(Background, IsTheMedianOfTheMeasuredDepths) {
  Background background;
  for (const int depth : {5, 0, 9, 7}) background.add({static_cast<std::uint16_t>(depth)});
  EXPECT_EQ(background.median(), std::vector<std::uint16_t>{7});
}

TEST(Background, IsUnknownWhereFewerThanHalfOfTheImagesMeasuredOne) {
  Background background;
  for (const int depth : {0, 0, 9, 0}) background.add({static_cast<std::uint16_t>(depth)});
  EXPECT_EQ(background.median(), std::vector<std::uint16_t>{0});
}

TEST(Background, HasNoPixelsWithoutAnImage) { EXPECT_TRUE(Background().median().empty()); }

TEST(Background, OnlyTheNewestImagesCount) {
  Background background;
  for (std::size_t i = 0; i < Background::kMost; ++i) background.add({1});
  for (std::size_t i = 0; i < Background::kMost / 2 + 1; ++i) background.add({2});
  EXPECT_EQ(background.median(), std::vector<std::uint16_t>{2});
}

}  // namespace
}  // namespace robot::truth
