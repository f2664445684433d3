#include "robot/truth/calibration/calibrate.h"

#include <gtest/gtest.h>

#include "robot/truth/synthetic/sensor_poses.h"
#include "tests/support/ground_picture.h"

namespace robot::truth {
namespace {

using tests::GroundScene;
using Clicks = std::vector<Click>;

/// A scene, its landmarks, and the ground of its image without noise.
struct Lab {
  GroundScene scene = tests::mast_scene();
  std::vector<Landmark> landmarks = landmarks_of(scene.field);
  Projection camera{scene.intrinsics, {}};
  DepthFrame image = scene.depth_image(nullptr);
  Ground ground = *find_ground(image, {}, {});

  Clicks clicks(double deviation = 0, unsigned seed = 1) const {
    std::mt19937 random(seed);
    return scene.clicks(random, deviation);
  }
};

/// One for all tests: an image takes a while without optimisation.
const Lab& lab() {
  static const Lab lab;
  return lab;
}

double difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) { return (a.matrix() - b.matrix()).norm(); }

/// Exchanges the sign before `axis` in the name of a landmark.
std::string turned(std::string name, char axis) {
  const std::string plus{'+', axis}, minus{'-', axis};
  if (const auto at = name.find(plus); at != std::string::npos)
    name[at] = '-';
  else if (const auto found = name.find(minus); found != std::string::npos)
    name[found] = '+';
  return name;
}

TEST(Calibrate, GivesTheExactPoseForExactClicks) {
  const auto calibration = calibrate(lab().landmarks, lab().clicks(), lab().image);
  ASSERT_TRUE(calibration) << calibration.error();
  // the image rounds depths to millimetres
  EXPECT_LT(difference(calibration->pose.field_from_sensor, lab().scene.field_from_sensor), 0.0005);
  EXPECT_NEAR(calibration->pose.depth_scale, 1, 0.0002);
  EXPECT_EQ(calibration->refused, "");
  EXPECT_LT(calibration->left_out.worst, 0.002);
  for (const ClickResidual& residual : calibration->residuals) {
    EXPECT_LT(residual.pixels, 0.1) << residual.click.landmark;
    EXPECT_FALSE(residual.outlier);
  }
}

TEST(Calibrate, NeedsNoDepthImage) {
  for (const auto& calibration : {calibrate(lab().landmarks, lab().clicks(), lab().camera, std::nullopt),
                                  calibrate(lab().landmarks, lab().clicks(), DepthFrame{})}) {
    ASSERT_TRUE(calibration) << calibration.error();
    EXPECT_EQ(calibration->refused, "");
    EXPECT_LT(difference(calibration->pose.field_from_sensor, lab().scene.field_from_sensor), 1e-6);
  }
}

TEST(Calibrate, FindsFocalLengthAndDistortionOfAColourCamera) {
  Projection camera{{.width = 1280, .height = 960, .focal_x = 800, .focal_y = 800, .centre_x = 640, .centre_y = 480},
                    {.k1 = -0.12}};
  const Eigen::Isometry3d field_from_camera = robot::truth::looking({-1, -3.5, 2.6}, {0, 0.4, 0}).field_from_sensor;
  Clicks clicks;
  for (const Landmark& landmark : lab().landmarks) {
    const Eigen::Vector3d seen = field_from_camera.inverse() * landmark.position;
    if (!camera.shows(seen)) continue;
    const Eigen::Vector2d pixel = camera.pixel(seen);
    clicks.push_back({landmark.name, pixel.x(), pixel.y()});
  }
  camera.intrinsics.focal_x = camera.intrinsics.focal_y = 830;
  camera.lens.k1 = 0;
  const auto calibration =
      calibrate(lab().landmarks, clicks, camera, std::nullopt, {.focal_free = true, .k1_free = true});
  ASSERT_TRUE(calibration) << calibration.error();
  EXPECT_EQ(calibration->refused, "");
  EXPECT_NEAR(calibration->pose.intrinsics.focal_x, 800, 2);
  EXPECT_NEAR(calibration->lens.k1, -0.12, 0.01);
  EXPECT_LT(difference(calibration->pose.field_from_sensor, field_from_camera), 0.02);
}

TEST(Calibrate, TurnsThePoseWithTheField) {
  const Clicks clicks = lab().clicks(1);
  Clicks other = clicks;
  for (Click& click : other) click.landmark = turned(turned(click.landmark, 'x'), 'y');
  const auto one = calibrate(lab().landmarks, clicks, lab().camera, lab().ground);
  const auto half_turn = calibrate(lab().landmarks, other, lab().camera, lab().ground);
  ASSERT_TRUE(one && half_turn);
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()));
  EXPECT_LT(difference(turn * one->pose.field_from_sensor, half_turn->pose.field_from_sensor), 1e-5);
  EXPECT_NEAR(one->robots.p95, half_turn->robots.p95, 1e-5);
}

TEST(Calibrate, MirrorsThePoseWithTheScene) {
  Clicks mirrored = lab().clicks(1);
  for (Click& click : mirrored) click = {turned(click.landmark, 'x'), lab().scene.intrinsics.width - click.x, click.y};
  Ground ground = lab().ground;
  ground.normal.x() *= -1;
  ground.roots.col(0) *= -1;
  const auto one = calibrate(lab().landmarks, lab().clicks(1), lab().camera, lab().ground);
  const auto other = calibrate(lab().landmarks, mirrored, lab().camera, ground);
  ASSERT_TRUE(one && other) << other.error();
  Eigen::Isometry3d expected = one->pose.field_from_sensor;
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  expected.linear() = mirror * expected.linear() * mirror;
  expected.translation() = mirror * expected.translation();
  EXPECT_LT(difference(expected, other->pose.field_from_sensor), 1e-5);
}

TEST(Calibrate, FindsTheScaleOfTheDepths) {
  GroundScene scene = lab().scene;
  scene.depth_scale = 0.99;
  std::mt19937 random(4);
  const auto calibration =
      calibrate(lab().landmarks, scene.clicks(random, 0.5), scene.depth_image(&random), {.click_deviation = 0.5});
  ASSERT_TRUE(calibration) << calibration.error();
  EXPECT_NEAR(calibration->pose.depth_scale, 0.99, 3 * calibration->scale_deviation);
  EXPECT_LT(calibration->scale_deviation, 0.005);
}

TEST(Calibrate, FindsOneClickThatIsFarOff) {
  for (const auto& ground : {std::optional<Ground>(lab().ground), std::optional<Ground>()}) {
    Clicks clicks = lab().clicks(0.5);
    clicks[4].x += 25;
    clicks[4].y += 31;
    const auto calibration = calibrate(lab().landmarks, clicks, lab().camera, ground);
    ASSERT_TRUE(calibration) << calibration.error();
    EXPECT_EQ(calibration->refused, "");
    for (std::size_t i = 0; i < clicks.size(); ++i) EXPECT_EQ(calibration->residuals[i].outlier, i == 4) << i;
    EXPECT_NEAR(calibration->residuals[4].pixels, std::hypot(25, 31), 6);
    EXPECT_LT(difference(calibration->pose.field_from_sensor, lab().scene.field_from_sensor), 0.05);
  }
}

TEST(Calibrate, CountsTheHiddenFootOfAPostLess) {
  const auto error_after_moving = [](const char* moved) {
    GroundScene scene = lab().scene;
    scene.field_from_sensor = robot::truth::looking({0, -4.5, 2.5}, {0, 0.5, 0}).field_from_sensor;
    std::mt19937 random(1);
    Clicks clicks = scene.clicks(random, 0);
    const Eigen::Vector2d post = scene.pose().pixel(find_landmark(lab().landmarks, "post +x +y, foot")->position);
    clicks.push_back({"post +x +y, foot", post.x(), post.y()});
    for (Click& click : clicks)
      if (click.landmark == moved) click.y += 3;
    const auto calibration = calibrate(lab().landmarks, clicks, lab().camera, std::nullopt);
    return calibration ? difference(calibration->pose.field_from_sensor, scene.field_from_sensor) : 1e9;
  };
  EXPECT_LT(error_after_moving("post +x +y, foot"), 0.3 * error_after_moving("goal area +x +y, goal line"));
}

TEST(Calibrate, NamesTheLandmarkThatTheOthersPlaceWorst) {
  Clicks clicks = lab().clicks();
  clicks[2].y += 3;
  const auto calibration = calibrate(lab().landmarks, clicks, lab().camera, lab().ground);
  ASSERT_TRUE(calibration) << calibration.error();
  EXPECT_EQ(calibration->left_out.landmark, clicks[2].landmark);
  EXPECT_GT(calibration->left_out.worst, 0.03);
  EXPECT_LT(calibration->left_out.mean, calibration->left_out.worst / 2);
}

}  // namespace
}  // namespace robot::truth
