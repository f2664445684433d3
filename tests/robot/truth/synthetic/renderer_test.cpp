#include "robot/truth/synthetic/renderer.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/synthetic/hall.h"

namespace robot::truth {
namespace {

constexpr RenderOptions kExact{.noise = false};

Scene some_scene() {
  Scene scene;
  scene.robots = {{.x = 0.5, .y = 0.2, .heading = 1}, {.x = -1, .y = 1, .fallen = true}};
  scene.ball = SceneBall{.x = -0.3, .y = -0.4};
  scene.people = {{.x = 1, .y = 1.5}};
  return scene;
}

TEST(Renderer, TheSameSceneAndNumberGiveTheSameImage) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  Renderer one(pose, kHall), other(pose, kHall);
  other.render({}, 1);  // earlier images leave no trace
  const DepthFrame a = one.render(some_scene(), 7), b = other.render(some_scene(), 7);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.rgb, b.rgb);
}

TEST(Renderer, AnotherNumberGivesOtherNoise) {
  Renderer renderer(mast(kField2012, -1, 0, kSmall), kHall);
  const DepthFrame a = renderer.render(some_scene(), 7), b = renderer.render(some_scene(), 8);
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.depth.size(); ++i) different += a.depth[i] != b.depth[i];
  EXPECT_GT(different, a.depth.size() / 4);
}

TEST(Renderer, AnExactImageOfABallIsItsSphere) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  Renderer renderer(pose, kHall, kExact);
  const Eigen::Vector3d centre(0.2, 0.1, 0.5);
  Scene scene;
  scene.ball = SceneBall{centre.x(), centre.y(), centre.z(), 0.3};
  const DepthFrame frame = renderer.render(scene, 0);
  int pixels = 0;
  for (int row = 0; row < kSmall.height; ++row)
    for (int column = 0; column < kSmall.width; ++column) {
      const std::size_t pixel = pixel_index(kSmall, row, column);
      if (renderer.cast().material[pixel] != Material::orange) continue;
      const Eigen::Vector3d point = pose.point(column + 0.5, row + 0.5, frame.depth[pixel] * frame.unit);
      EXPECT_NEAR((point - centre).norm(), 0.3, 0.001);
      ++pixels;
    }
  EXPECT_GT(pixels, 300);
}

TEST(Renderer, TheFirstPixelsCentreIsAtOneHalf) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  Renderer renderer(pose, kHall, kExact);
  for (const double x : {-0.313, 0.1, 0.227}) {
    Scene scene;
    scene.ball = SceneBall{x, 0.3, 0.1, 0.1};
    renderer.render(scene, 0);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double count = 0;
    for (int row = 0; row < kSmall.height; ++row)
      for (int column = 0; column < kSmall.width; ++column)
        if (renderer.cast().material[pixel_index(kSmall, row, column)] == Material::orange)
          ++count, sum += Eigen::Vector2d(column + 0.5, row + 0.5);
    EXPECT_LT((sum / count - pose.pixel({x, 0.3, 0.1})).norm(), 0.3) << x;
  }
}

TEST(Renderer, NearerThingsHideThoseBehindInAnyOrder) {
  const SensorPose pose = mast(kField2012, -1, 0, kSmall);
  Renderer one(pose, kHall, kExact), other(pose, kHall, kExact);
  const Scene scene{.robots = {{.x = 0, .y = -0.3}, {.x = 0, .y = 0.1}}};
  const Scene turned{.robots = {scene.robots[1], scene.robots[0]}};
  EXPECT_EQ(one.render(scene, 0).depth, other.render(turned, 0).depth);
}

TEST(Renderer, AThingBehindTheSensorOrAtItIsNotDrawn) {
  Renderer renderer(mast(kField2012, -1, 0, kSmall), kHall, kExact);
  const std::vector<std::uint16_t> empty = renderer.render({}, 0).depth;
  Scene scene;
  scene.ball = SceneBall{0, -5, 2, 0.1};
  EXPECT_EQ(renderer.render(scene, 0).depth, empty);
  scene.ball = SceneBall{0, -3.2, 2.1, 0.1};
  EXPECT_EQ(renderer.render(scene, 0).depth, empty);
}

TEST(Renderer, MeasuredDepthTimesTheScaleIsTheTrueDepth) {
  SensorPose pose = mast(kField2012, -1, 0, kSmall);
  pose.depth_scale = 1.02;
  Renderer renderer(pose, kHall, kExact);
  const DepthFrame frame = renderer.render(some_scene(), 0);
  for (std::size_t pixel = 0; pixel < frame.depth.size(); pixel += 13)
    EXPECT_NEAR(frame.depth[pixel] * frame.unit * 1.02, static_cast<double>(renderer.cast().depth[pixel]), 0.001);
}

TEST(Renderer, ColourIsLeftOutOnDemand) {
  Renderer renderer(mast(kField2012, -1, 0, kSmall), kHall, {.colour = false});
  EXPECT_TRUE(renderer.render(some_scene(), 0).rgb.empty());
}

}  // namespace
}  // namespace robot::truth
