#include "robot/truth/synthetic/sensor_poses.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/synthetic/hall.h"

namespace robot::truth {
namespace {

TEST(SensorPoses, TheTargetIsInTheMiddleOfTheImage) {
  const SensorPose pose = looking({1, -3, 2}, {-0.5, 0.7, 0.1});
  EXPECT_LT((pose.pixel({-0.5, 0.7, 0.1}) - Eigen::Vector2d(320, 240)).norm(), 1e-9);
}

TEST(SensorPoses, TheHorizonIsLevelInTheImage) {
  const SensorPose pose = looking({1, -3, 2}, {-0.5, 0.7, 0.1});
  EXPECT_NEAR(pose.field_from_sensor.linear().col(0).z(), 0, 1e-12);
  EXPECT_LT(pose.field_from_sensor.linear().col(1).z(), 0) << "+y of the sensor is down";
  EXPECT_NEAR(pose.field_from_sensor.linear().determinant(), 1, 1e-12);
}

TEST(SensorPoses, TheMastIs2Point1MetresHighAnd1Point2BehindTheTouchLine) {
  EXPECT_TRUE(mast(kField2012).field_from_sensor.translation().isApprox(Eigen::Vector3d(0, -3.2, 2.1)));
  EXPECT_TRUE(mast(kField2012, +1, 2).field_from_sensor.translation().isApprox(Eigen::Vector3d(2, 3.2, 2.1)));
}

TEST(SensorPoses, TheMastLooksToAPlace3Point4MetresBeforeIt) {
  const Eigen::Vector2d middle(kSmall.centre_x, kSmall.centre_y);
  EXPECT_LT((mast(kField2012, -1, 0.5, kSmall).pixel({0.5, 0.2, 0}) - middle).norm(), 1e-5);
  EXPECT_LT((mast(kField2012, +1, 0.5, kSmall).pixel({0.5, -0.2, 0}) - middle).norm(), 1e-5);
}

}  // namespace
}  // namespace robot::truth
