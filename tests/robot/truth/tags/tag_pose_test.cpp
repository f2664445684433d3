#include "robot/truth/tags/tag_pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/camera_above.h"

namespace {

using robot::truth::tags::Camera;
using robot::truth::tags::Corners;
using robot::truth::tags::corners_in_picture;
using robot::truth::tags::free_pose;
using robot::truth::tags::kCornerDeviation;
using robot::truth::tags::kShine;
using robot::truth::tags::kShineDeviation;
using robot::truth::tags::standing_pose;
using tests::camera_above;
using tests::flat_tag;
using tests::kDegree;

constexpr double kEdge = 0.14, kHeight = 0.5;

Camera slanting_camera() {
  Camera camera = camera_above({-1, -1.5, 2.8}, {0, 0}, {1280, 720}, 700);
  camera.projection.lens.k1 = -0.1;
  camera.projection.lens.p1 = 0.001;
  return camera;
}

Eigen::Isometry3d turned(const Eigen::Isometry3d& pose, double angle, const Eigen::Vector3d& axis) {
  Eigen::Isometry3d result = pose;
  result.linear() = Eigen::AngleAxisd(angle, axis.normalized()) * pose.linear();
  return result;
}

/// Normal random numbers of deviation 1, the same with every library.
double normal(std::mt19937& random) {
  const double u = (static_cast<double>(random()) + 1) / 4294967296.0;
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * static_cast<double>(random()) / 4294967296.0);
}

TEST(TagPose, TagStraightBelowTheCamera) {
  const Camera camera = camera_above({0, 0, 3}, {0, 0}, {640, 480}, 700);
  const double half = 0.07 * 700 / 2.5 - kShine;  // [px] the tag is 2.5 m below; the picture's upper edge is at +y
  const Corners corners{
      {{320 - half, 240 + half}, {320 + half, 240 + half}, {320 + half, 240 - half}, {320 - half, 240 - half}}};
  const auto pose = standing_pose(camera, corners, kEdge, kHeight);
  ASSERT_TRUE(pose);
  EXPECT_LT((pose->field_from_tag.translation() - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-6);
  EXPECT_LT((pose->upper_edge() - Eigen::Vector3d::UnitY()).norm(), 1e-6);
  EXPECT_LT(pose->tilt(), 1e-3);
  EXPECT_LT(pose->cost, 1e-6);
}

TEST(TagPose, ExactCornersGiveTheExactFlatPose) {
  const Camera camera = slanting_camera();
  for (const double turn : {-3.0, -1.0, 0.3, 2.0}) {
    const Eigen::Isometry3d truth = flat_tag({0.8, 0.5, kHeight}, turn);
    const auto pose = standing_pose(camera, *corners_in_picture(camera, truth, kEdge), kEdge, kHeight);
    ASSERT_TRUE(pose);
    EXPECT_TRUE(pose->field_from_tag.isApprox(truth, 1e-6)) << turn;
  }
}

TEST(TagPose, ASwayingTagKeepsItsPlaceAndHeading) {
  const Camera camera = slanting_camera();
  for (int direction = 0; direction < 8; ++direction) {
    const double angle = direction * 45 * kDegree;
    const auto truth =
        turned(flat_tag({0.5, 0.3, kHeight + 0.005}, 1), 8 * kDegree, {std::cos(angle), std::sin(angle), 0});
    const auto pose = standing_pose(camera, *corners_in_picture(camera, truth, kEdge), kEdge, kHeight);
    ASSERT_TRUE(pose);
    EXPECT_LT((pose->field_from_tag.translation() - truth.translation()).norm(), 0.007) << direction;
    EXPECT_LT(std::acos(std::min(1.0, pose->upper_edge().dot(truth.linear().col(1)))), 2 * kDegree) << direction;
  }
}

TEST(TagPose, TheCovarianceIsThatOfTheErrors) {
  std::mt19937 random(3);
  const Camera camera = slanting_camera();
  double places = 0, headings = 0;
  constexpr int kTrials = 100;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Vector3d sway(5 * kDegree * normal(random), 5 * kDegree * normal(random), 0);
    const auto truth = turned(flat_tag({0.7, 0.4, kHeight + 0.01 * normal(random)}, trial), sway.norm(), sway);
    Corners corners = *corners_in_picture(camera, truth, kEdge, kShine + kShineDeviation * normal(random));
    for (auto& corner : corners) corner += kCornerDeviation * Eigen::Vector2d(normal(random), normal(random));
    const auto pose = standing_pose(camera, corners, kEdge, kHeight);
    ASSERT_TRUE(pose);
    const Eigen::Vector2d error = (pose->field_from_tag.translation() - truth.translation()).head<2>();
    places += error.dot(pose->covariance.topLeftCorner<2, 2>().inverse() * error) / 2 / kTrials;
    const Eigen::AngleAxisd turn(pose->field_from_tag.linear() * truth.linear().transpose());
    headings += std::pow(turn.angle() * turn.axis().z(), 2) / pose->covariance(5, 5) / kTrials;
  }
  EXPECT_NEAR(places, 1, 0.3);
  EXPECT_NEAR(headings, 1, 0.3);
}

TEST(TagPose, AFreePoseIsFoundAnywhere) {
  const Camera camera = slanting_camera();
  for (const double tilt : {0.0, 30.0, 60.0})
    for (const double turn : {0.0, 1.0, 2.0, 3.0}) {
      const auto truth = turned(flat_tag({0.2, 0.1, 0.2}, turn), tilt * kDegree, {1, 0.3, 0});
      const auto pose = free_pose(camera, *corners_in_picture(camera, truth, kEdge), kEdge);
      ASSERT_TRUE(pose);
      EXPECT_TRUE(pose->field_from_tag.isApprox(truth, 1e-4)) << tilt << ", " << turn;
      EXPECT_NEAR(pose->tilt(), tilt * kDegree, 1e-3);
    }
}

TEST(TagPose, CornersAboveTheHorizonGiveNoStandingPose) {
  const Camera camera = camera_above({0, 0, 1}, {5, 0}, {640, 480}, 300);
  const Corners corners{{{300, 20}, {320, 20}, {320, 10}, {300, 10}}};
  EXPECT_FALSE(standing_pose(camera, corners, kEdge, kHeight));
}

TEST(TagPose, CornersOnOnePointOrOneLineGiveNothingOrAHighCost) {
  const Camera camera = slanting_camera();
  const Eigen::Vector2d point(600, 300);
  for (const Corners& corners :
       {Corners{point, point, point, point}, Corners{point, point + Eigen::Vector2d(10, 0),
                                                     point + Eigen::Vector2d(20, 0), point + Eigen::Vector2d(30, 0)}}) {
    const auto standing = standing_pose(camera, corners, kEdge, kHeight);
    EXPECT_TRUE(!standing || standing->cost > 100);
    const auto anywhere = free_pose(camera, corners, kEdge);
    EXPECT_TRUE(!anywhere || anywhere->cost > 100 || anywhere->field_from_tag.translation().norm() > 10);
  }
}

}  // namespace
