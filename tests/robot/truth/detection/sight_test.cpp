#include "robot/truth/detection/sight.h"

#include <gtest/gtest.h>

#include "robot/truth/synthetic/renderer.h"
#include "tests/robot/truth/synthetic/hall.h"

namespace robot::truth {
namespace {

constexpr double kUnit = 0.001, kLowest = 0.025;

TEST(Sight, ARayLeadsToThePointOfThePose) {
  SensorPose pose = mast(kField2012, -1, 0, kSmall);
  pose.depth_scale = 1.01;
  const Sight sight(pose, kField2012, kUnit, kLowest);
  const Eigen::Vector3f point = sight.eye() + 3000 * sight.ray(50, 30);
  EXPECT_LT((point.cast<double>() - pose.point(30.5, 50.5, 3)).norm(), 1e-5);
  EXPECT_LT((sight.sensor_ray(50, 30).cast<double>() - pose.ray(30.5, 50.5)).norm(), 1e-6);
  EXPECT_NEAR(sight.metres(3000), 3.03, 1e-5);
}

TEST(Sight, NoticesThingsOnTheCarpetAndNotTheCarpet) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  const Sight sight(pose, kField2012, kUnit, kLowest);
  Renderer renderer(pose, {.field = kField2012, .goals = false}, {.noise = false});
  Scene scene;
  scene.robots = {{.x = 0.2, .y = 0.1}};
  const DepthFrame frame = renderer.render(scene, 0);
  for (int row = 0; row < kSmall.height; ++row)
    for (int column = 0; column < kSmall.width; ++column) {
      const std::size_t pixel = pixel_index(kSmall, row, column);
      const double height = pose.point(column + 0.5, row + 0.5, frame.depth[pixel] * kUnit).z();
      const bool thing = renderer.cast().material[pixel] == Material::robot;
      if (thing && height <= 0.1) continue;
      EXPECT_EQ(sight.notices(frame, row, column), thing) << row << " " << column;
    }
}

TEST(Sight, CutsAwayThePixelsThatNeverSeeTheField) {
  // the horizon is in the middle of this image
  const Sight level(looking({0, -3.2, 1}, {0, 0, 1}, kSmall), kField2012, kUnit, kLowest);
  EXPECT_GE(level.end_row(), kSmall.height - 1);
  const Sight away(looking({0, -6, 2}, {0, -9, 1}, kSmall), kField2012, kUnit, kLowest);
  EXPECT_GE(away.first_row(), away.end_row()) << "it looks away from the field";
  // the right half of this image is beside the field
  const Sight aside(looking({5, -6, 2}, {5, 0, 0}, kSmall), kField2012, kUnit, kLowest);
  EXPECT_LT(aside.columns(60).end, kSmall.width / 2);
}

TEST(Sight, AnUnmeasuredPixelNoticesNothing) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  const Sight sight(pose, kField2012, kUnit, kLowest);
  DepthFrame frame;
  frame.depth.assign(160 * 120, 0);
  for (int row = 0; row < kSmall.height; ++row)
    for (int column = 0; column < kSmall.width; ++column) EXPECT_FALSE(sight.notices(frame, row, column));
}

TEST(Sight, ABackgroundReplacesThePlane) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  Sight sight(pose, kField2012, kUnit, kLowest);
  DepthFrame frame;
  frame.depth.assign(160 * 120, 2000);
  EXPECT_TRUE(sight.notices(frame, 60, 80));
  sight.set_background(frame.depth);
  EXPECT_FALSE(sight.notices(frame, 60, 80));
  EXPECT_NEAR(sight.background(60, 80), 2, 1e-5);
  frame.depth.assign(160 * 120, 1900);
  EXPECT_TRUE(sight.notices(frame, 60, 80));
}

TEST(Sight, TheCarpetIsTheFieldWithItsBorder) {
  const Sight sight(mast(kField2012, -1, 0, kSmall), kField2012, kUnit, kLowest);
  EXPECT_TRUE(sight.on_carpet({3.69, -2.69}));
  EXPECT_FALSE(sight.on_carpet({3.71, 0}));
  EXPECT_FALSE(sight.on_carpet({0, -2.71}));
}

}  // namespace
}  // namespace robot::truth
