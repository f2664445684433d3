#include "robot/truth/synthetic/surroundings.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/synthetic/hall.h"

namespace robot::truth {
namespace {

/// The pixel that shows a place [m, field].
std::size_t pixel_of(const SensorPose& pose, const Eigen::Vector3d& place) {
  const Eigen::Vector2d pixel = pose.pixel(place);
  return pixel_index(pose.intrinsics, static_cast<int>(pixel.y()), static_cast<int>(pixel.x()));
}

/// A sensor high above a place.
SensorPose above(double x, double y) { return looking({x, y - 0.01, 3}, {x, y, 0}, kSmall); }

TEST(Surroundings, EachPixelOfTheFloorIsAtHeightZero) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  const Cast cast = cast_of({.field = kField2012, .goals = false, .walls = 0}, pose);
  for (int row = 0; row < kSmall.height; row += 7)
    for (int column = 0; column < kSmall.width; column += 7) {
      const std::size_t pixel = pixel_index(kSmall, row, column);
      if (cast.depth[pixel] == kFar) continue;
      const double depth = static_cast<double>(cast.depth[pixel]);
      EXPECT_NEAR(pose.point(column + 0.5, row + 0.5, depth).z(), 0, 1e-5);
    }
}

TEST(Surroundings, LinesAreWhereTheFieldHasThem) {
  const auto material_at = [](double x, double y) {
    const SensorPose pose = above(x, y);
    return cast_of(kHall, pose).material[pixel_of(pose, {x, y, 0})];
  };
  // the centre line, a touch line, the circle, a penalty mark, the front of a goal area
  for (const auto& [x, y] : {std::pair{0., 1.}, {1., 2.}, {0.6, 0.}, {-1.7, 0.}, {2.4, 0.5}})
    EXPECT_EQ(material_at(x, y), Material::line) << x << " " << y;
  for (const auto& [x, y] : {std::pair{0.3, 0.1}, {1., 1.9}, {0.7, 0.}, {2.5, 0.5}, {3.3, 0.}})
    EXPECT_EQ(material_at(x, y), Material::carpet) << x << " " << y;
}

TEST(Surroundings, BothGoalsHavePostsAndACrossbar) {
  for (const double end : {-1., 1.}) {
    const SensorPose pose = looking({end * 0.5, 0, 0.6}, {end * 3, 0, 0.6}, kSmall);
    const Cast cast = cast_of(kHall, pose), without = cast_of({.field = kField2012, .goals = false}, pose);
    for (const double y : {-0.7, 0.7}) EXPECT_EQ(cast.material[pixel_of(pose, {end * 2.95, y, 0.4})], Material::post);
    EXPECT_EQ(cast.material[pixel_of(pose, {end * 2.95, 0.2, 0.8})], Material::post);
    EXPECT_EQ(without.material[pixel_of(pose, {end * 2.95, 0.2, 0.8})], Material::wall);
  }
}

TEST(Surroundings, WallsStandBehindTheCarpetOrAreAbsent) {
  const SensorPose pose = looking({0, 0, 1}, {0, 1, 1}, kSmall);
  const std::size_t middle = pixel_of(pose, {0, 1, 1});
  const Cast walls = cast_of({.field = kField2012, .walls = 1.5}, pose);
  EXPECT_NEAR(walls.depth[middle], 2 + 0.7 + 1.5, 1e-5);
  EXPECT_EQ(walls.material[middle], Material::wall);
  const Cast open = cast_of({.field = kField2012, .walls = 0}, looking({0, 0, 1}, {0, 1, 1.5}, kSmall));
  EXPECT_EQ(open.depth[middle], kFar);
  EXPECT_EQ(open.material[middle], Material::nothing);
}

}  // namespace
}  // namespace robot::truth
