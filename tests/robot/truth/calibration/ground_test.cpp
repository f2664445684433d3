#include "robot/truth/calibration/ground.h"

#include <gtest/gtest.h>

#include "robot/truth/synthetic/sensor_poses.h"
#include "tests/support/ground_picture.h"

namespace robot::truth {
namespace {

using tests::GroundScene;

/// A quarter of the pixels is enough here.
GroundScene small(GroundScene scene) {
  scene.intrinsics = {
      .width = 320, .height = 240, .focal_x = 287.9, .focal_y = 287.9, .centre_x = 160, .centre_y = 120};
  return scene;
}

std::vector<Eigen::Vector2d> pixels_of(const GroundScene& scene) {
  std::mt19937 random(1);
  std::vector<Eigen::Vector2d> pixels;
  for (const Click& click : scene.clicks(random, 0)) pixels.emplace_back(click.x, click.y);
  return pixels;
}

void expect_carpet(const GroundScene& scene, const Result<Ground>& ground, double degrees, double metres) {
  ASSERT_TRUE(ground) << ground.error();
  const Eigen::Vector3d up = scene.field_from_sensor.linear().row(2).transpose();
  EXPECT_LT(std::acos(std::min(1., up.dot(ground->normal))) * 180 / M_PI, degrees);
  EXPECT_NEAR(ground->height * scene.depth_scale, scene.field_from_sensor.translation().z(), metres);
}

TEST(Ground, IsTheCarpetBetweenRobotsPeopleAndWalls) {
  const GroundScene scene = small(tests::mast_scene());
  expect_carpet(scene, find_ground(scene.depth_image(nullptr), {}, pixels_of(scene)), 0.01, 0.001);
  std::mt19937 random(3);
  expect_carpet(scene, find_ground(scene.depth_image(&random), {}, pixels_of(scene)), 0.2, 0.005);
}

TEST(Ground, IsThePlaneOfTheClicksAlsoWhereAWallHasMorePixels) {
  GroundScene scene = small(tests::mast_scene());
  scene.field_from_sensor = robot::truth::looking({0, -3.2, 1.5}, {0, 0, 1.2}).field_from_sensor;
  scene.boxes = {{{-5, 1.4}, {5, 1.6}, 4}};
  std::vector<Eigen::Vector2d> clicks;
  for (const double x : {-0.8, -0.2, 0.3, 0.9}) clicks.push_back(scene.pose().pixel({x, 0.5 * x, 0}));
  std::mt19937 random(3);
  expect_carpet(scene, find_ground(scene.depth_image(&random), {}, clicks), 0.4, 0.01);
}

TEST(Ground, FollowsTheScaleOfTheDepths) {
  GroundScene scene = small(tests::mast_scene());
  scene.depth_scale = 0.9;
  expect_carpet(scene, find_ground(scene.depth_image(nullptr), {}, pixels_of(scene)), 0.01, 0.001);
}

TEST(Ground, SumsTheDistancesOfItsPixelsInFourNumbers) {
  const GroundScene scene = small(tests::mast_scene());
  const auto ground = find_ground(scene.depth_image(nullptr), {}, pixels_of(scene));
  ASSERT_TRUE(ground);
  const auto sum = [&](double lifted) {
    const Eigen::Vector4d plane(ground->normal.x(), ground->normal.y(), ground->normal.z(), ground->height + lifted);
    return (ground->roots * plane).squaredNorm();
  };
  // distances of the rounding to millimetres only; then a centimetre for each pixel, whose deviation is 3 mm to 5 cm
  EXPECT_LT(sum(0), 0.01 * ground->pixels);
  EXPECT_GT(sum(0.01), ground->pixels * 0.2 * 0.2);
  EXPECT_LT(sum(0.01), ground->pixels * 3.4 * 3.4);
  EXPECT_NEAR(sum(0.02) / sum(0.01), 4, 0.05);
}

TEST(Ground, IsRefusedForAnImageOfAnotherSize) {
  DepthFrame frame{.intrinsics = {.width = 4, .height = 3}, .depth = {1, 2, 3}};
  EXPECT_EQ(find_ground(frame, {}, {}).error(), "depth image: expected 4 x 3 depths, got 3");
}

TEST(Ground, IsRefusedForAnImageWithoutDepths) {
  DepthFrame frame{.intrinsics = {.width = 64, .height = 48}};
  frame.depth.assign(64 * 48, 0);
  EXPECT_EQ(find_ground(frame, {}, {}).error(),
            "depth image: expected a carpet of at least 100 measured points around the clicks, got 0");
}

}  // namespace
}  // namespace robot::truth
