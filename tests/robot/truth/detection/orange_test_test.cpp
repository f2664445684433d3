#include "robot/truth/detection/orange_test.h"

#include <gtest/gtest.h>

namespace robot::truth {
namespace {

bool orange(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  const std::uint8_t rgb[] = {red, green, blue};
  return OrangeTest({})(rgb);
}

TEST(OrangeTest, KnowsOrangeByHueSaturationAndBrightness) {
  EXPECT_TRUE(orange(235, 110, 25));
  EXPECT_TRUE(orange(120, 55, 12)) << "in shade";
  EXPECT_FALSE(orange(235, 28, 25)) << "red: a hue of 1 degree";
  EXPECT_FALSE(orange(235, 200, 25)) << "yellow: a hue of 50 degrees";
  EXPECT_FALSE(orange(235, 170, 140)) << "skin: a saturation of 0.4";
  EXPECT_FALSE(orange(60, 28, 6)) << "dark";
}

TEST(OrangeTest, OtherColoursAreNotOrange) {
  EXPECT_FALSE(orange(0, 0, 0));
  EXPECT_FALSE(orange(255, 255, 255));
  EXPECT_FALSE(orange(40, 120, 50));
  EXPECT_FALSE(orange(40, 50, 200));
  EXPECT_FALSE(orange(200, 20, 180));
}

}  // namespace
}  // namespace robot::truth
