#include "robot/net/scene/depth_points.h"

#include <gtest/gtest.h>

#include <cstring>

namespace robot::net {
namespace {

constexpr int kWidth = 4, kHeight = 2;

/// A sensor 2 m above the centre that looks straight down, with +x of the image along +x of the field.
foresight::TruthSensor overhead() {
  foresight::TruthSensor sensor;
  auto& pinhole = *sensor.mutable_pinhole();
  pinhole.set_width(kWidth), pinhole.set_height(kHeight);
  pinhole.set_focal_x(2), pinhole.set_focal_y(2);
  pinhole.set_centre_x(0.5f), pinhole.set_centre_y(0.5f);
  for (const float value : {1.f, 0.f, 0.f, 0.f, -1.f, 0.f, 0.f, 0.f, -1.f}) sensor.mutable_place()->add_rotation(value);
  sensor.mutable_place()->set_z(2);
  sensor.mutable_place()->set_depth_scale(1);
  return sensor;
}

::foxglove::RawImage image_of(std::vector<std::uint16_t> depths) {
  ::foxglove::RawImage image;
  image.set_width(kWidth), image.set_height(kHeight), image.set_step(2 * kWidth);
  image.set_encoding("16UC1");
  image.set_data(reinterpret_cast<const char*>(depths.data()), 2 * depths.size());
  return image;
}

/// Returns the places of the points in a serialised cloud.
std::vector<std::array<float, 3>> places_in(const std::string& cloud, std::size_t points) {
  std::vector<std::array<float, 3>> places(points);
  const std::size_t data = cloud.size() - 16 * points;
  for (std::size_t i = 0; i < points; ++i) std::memcpy(places[i].data(), cloud.data() + data + 16 * i, 12);
  return places;
}

TEST(DepthPoints, EverySecondMeasuredPixelIsAPointOnTheField) {
  const auto cloud = depth_points(image_of({2000, 1, 1000, 1, 1, 1, 1, 1}), overhead(), 5);
  ASSERT_TRUE(cloud) << cloud.error();
  const auto places = places_in(*cloud, 2);
  EXPECT_EQ(places[0], (std::array<float, 3>{0, 0, 0}));
  EXPECT_EQ(places[1], (std::array<float, 3>{1, 0, 1}));  // two pixels beside the axis, focal length 2, 1 m away
}

TEST(DepthPoints, PixelsWithoutDepthAreNoPoints) {
  const auto none = depth_points(image_of({0, 0, 0, 0, 0, 0, 0, 0}), overhead(), 5);
  const auto one = depth_points(image_of({1500, 0, 0, 0, 0, 0, 0, 0}), overhead(), 5);
  ASSERT_TRUE(none && one);
  EXPECT_GE(one->size(), none->size() + 16);
}

TEST(DepthPoints, TheDepthScaleCounts) {
  foresight::TruthSensor sensor = overhead();
  sensor.mutable_place()->set_depth_scale(0.5f);
  const auto cloud = depth_points(image_of({2000, 0, 0, 0, 0, 0, 0, 0}), sensor, 5);
  ASSERT_TRUE(cloud);
  EXPECT_EQ(places_in(*cloud, 1)[0][2], 1);
}

TEST(DepthPoints, AnImageOfAnotherKindOrSizeIsRefused) {
  ::foxglove::RawImage image = image_of({0, 0, 0, 0, 0, 0, 0, 0});
  image.set_encoding("rgb8");
  const auto colours = depth_points(image, overhead(), 5);
  ASSERT_FALSE(colours);
  EXPECT_NE(colours.error().find("16UC1"), std::string::npos);
  foresight::TruthSensor sensor = overhead();
  sensor.mutable_pinhole()->set_width(640);
  const auto size = depth_points(image_of({0, 0, 0, 0, 0, 0, 0, 0}), sensor, 5);
  ASSERT_FALSE(size);
  EXPECT_NE(size.error().find("4x2"), std::string::npos);
}

}  // namespace
}  // namespace robot::net
