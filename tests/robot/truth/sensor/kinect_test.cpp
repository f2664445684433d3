// Depths and colours of the first Kinect.
#include "robot/truth/sensor/kinect.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::truth {
namespace {

TEST(Kinect, ConvertsDisparitiesByThePublishedFormula) {
  // 8 * 575.8 px * 75 mm / (1090 - raw)
  EXPECT_EQ(depth_of_disparity(1000), 3839);
  EXPECT_EQ(depth_of_disparity(745), 1001);
  // within 2 % of the two other published fits, up to 3 m: OpenKinect wiki, "Imaging information"
  for (std::uint16_t raw = 500; raw <= 975; ++raw) {
    const double tangent = 123.6 * std::tan(raw / 2842.5 + 1.1863);
    EXPECT_NEAR(depth_of_disparity(raw), tangent, 0.02 * tangent) << raw;
  }
}

TEST(Kinect, AStepOfDisparityIsAStepOfTheNoiseModel) {
  const Intrinsics intrinsics = kinect_intrinsics(640, 480);
  for (std::uint16_t raw = 900; raw < 1040; ++raw) {
    const double here = depth_of_disparity(raw), there = depth_of_disparity(static_cast<std::uint16_t>(raw + 1));
    const double between = (here + there) / 2000;  // [m]
    EXPECT_NEAR((there - here) / 1000, DepthNoise::step(intrinsics, between), 0.0011) << raw;
  }
}

TEST(Kinect, HasNoDepthBehindTheGreatestDisparity) {
  for (const int raw : {1085, 1090, 1500, 2046, 2047, 2048, 65535})
    EXPECT_EQ(depth_of_disparity(static_cast<std::uint16_t>(raw)), 0) << raw;
}

TEST(Kinect, ItsDefaultsAreThoseOfTheIntrinsics) {
  EXPECT_EQ(kinect_intrinsics(640, 480), Intrinsics{});
  const Intrinsics half = kinect_intrinsics(320, 240);
  EXPECT_DOUBLE_EQ(half.focal_x, Intrinsics{}.focal_x / 2);
  EXPECT_DOUBLE_EQ(half.centre_y, 120);
}

TEST(Kinect, AllBlackAndAllUnmeasuredAreValidImages) {
  for (const std::uint16_t value : {std::uint16_t{0}, kNoDisparity}) {
    const GreyImage image{640, 480, std::vector<std::uint16_t>(640 * 480, value)};
    const Result<DepthFrame> frame = kinect_frame(image, nullptr);
    ASSERT_TRUE(frame) << frame.error();
    EXPECT_EQ(frame->intrinsics, Intrinsics{});
    EXPECT_TRUE(frame->rgb.empty());
    const std::uint16_t depth = depth_of_disparity(value);
    EXPECT_EQ(frame->depth, std::vector<std::uint16_t>(640 * 480, depth));
    EXPECT_EQ(depth == 0, value == kNoDisparity);
  }
}

TEST(Kinect, RefusesValuesThatAreNoDisparities) {
  const GreyImage swapped{2, 1, {1000, 0xff07}};
  EXPECT_EQ(kinect_frame(swapped, nullptr).error(),
            "expected disparities of 11 bits (0 to 2047), got 65287 in pixel 1");
}

/// A colour image in which each pixel's red is its column / 4.
ColourImage columns() {
  ColourImage image{640, 480, std::vector<std::uint8_t>(3 * 640 * 480)};
  for (std::size_t i = 0; i < 640 * 480; ++i) image.rgb[3 * i] = static_cast<std::uint8_t>(i % 640 / 4);
  return image;
}

TEST(Kinect, FindsTheColoursOfItsPixels) {
  DepthFrame frame;
  frame.depth.assign(640 * 480, 0);
  const std::size_t middle = 240 * 640 + 320;
  frame.depth[middle] = 2000;
  const std::vector<std::uint8_t> rgb = registered_colours(frame, columns());
  ASSERT_EQ(rgb.size(), 3u * 640 * 480);
  // 25 mm at 2 m are 6.6 px to the left for the colour camera, which is right of the depth camera
  EXPECT_EQ(rgb[3 * middle], 313 / 4);
  // a pixel to the right has no depth and takes this one; the one to the left has none to take
  EXPECT_EQ(rgb[3 * (middle + 20)], 332 / 4);
  EXPECT_EQ(rgb[3 * (middle - 1)], 0);
  // the next row starts anew
  EXPECT_EQ(rgb[3 * (241 * 640 + 330)], 0);
}

TEST(Kinect, PixelsOutsideTheColourImageAreBlack) {
  DepthFrame frame;
  frame.depth.assign(640 * 480, 300);
  ColourImage white{640, 480, std::vector<std::uint8_t>(3 * 640 * 480, 255)};
  const std::vector<std::uint8_t> rgb = registered_colours(frame, white);
  // at 0.3 m the colour camera sees 44 px less on the left, but its view is wider
  EXPECT_EQ(rgb[3 * (240 * 640)], 0);
  EXPECT_EQ(rgb[3 * (240 * 640 + 639)], 255);
}

}  // namespace
}  // namespace robot::truth
