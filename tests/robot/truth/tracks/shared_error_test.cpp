#include "robot/truth/tracks/shared_error.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/tracks/images.h"
#include "tests/support/truth_game.h"

namespace robot::truth {
namespace {

Sensor uncertain_sensor() {
  Sensor sensor = sensor_beside(0.01, 0.004);
  sensor.pose.depth_scale = 1.02;
  sensor.pose.covariance(6, 6) = 0.01 * 0.01;
  return sensor;
}

/// Returns the pose with an error drawn from its covariance, which is diagonal.
SensorPose drawn_pose(const SensorPose& pose, test::Random& random) {
  Eigen::Matrix<double, 7, 1> error;
  for (int i = 0; i < 7; ++i) error[i] = std::sqrt(pose.covariance(i, i)) * random.normal();
  SensorPose wrong = pose;
  const Eigen::Vector3d turn = error.head<3>();
  wrong.field_from_sensor.linear() =
      pose.field_from_sensor.linear() * Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  wrong.field_from_sensor.translation() += error.segment<3>(3);
  wrong.depth_scale += error[6];
  return wrong;
}

/// Returns the place of the point that the sensor sees in this pixel, as a wrong pose has it.
Eigen::Vector2d misplaced(const SensorPose& right, const SensorPose& wrong, const Eigen::Vector3d& point,
                          Ranging ranging) {
  const Eigen::Vector2d pixel = right.pixel(point);
  const double depth = (right.field_from_sensor.inverse() * point).z() / right.depth_scale;
  if (ranging == Ranging::depth) return wrong.point(pixel.x(), pixel.y(), depth).head<2>();
  const Eigen::Vector3d eye = wrong.field_from_sensor.translation();
  const Eigen::Vector3d ray = wrong.field_from_sensor.linear() * wrong.ray(pixel.x(), pixel.y());
  return (eye + ray * (point.z() - eye.z()) / ray.z()).head<2>();
}

TEST(SharedCovariance, IsThatOfPlacesWithDrawnErrorsOfThePose) {
  const SensorPose pose = uncertain_sensor().pose;
  const Eigen::Vector3d point(1.2, 0.7, 0.1);
  for (const Ranging ranging : {Ranging::depth, Ranging::plane}) {
    test::Random random(3);
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    constexpr int trials = 4000;
    for (int i = 0; i < trials; ++i) {
      const Eigen::Vector2d error = misplaced(pose, drawn_pose(pose, random), point, ranging) - point.head<2>();
      sum += error * error.transpose() / trials;
    }
    const Eigen::Matrix2d expected = shared_covariance(pose, point, ranging);
    EXPECT_LT((sum - expected).norm(), 0.08 * expected.norm()) << sum << "\n" << expected;
  }
}

TEST(SharedCovariance, OfAnExactPoseIsZero) {
  for (const Ranging ranging : {Ranging::depth, Ranging::plane}) {
    EXPECT_EQ(shared_covariance(sensor_beside(0).pose, {1, 1, 0}, ranging), Eigen::Matrix2d::Zero());
    EXPECT_EQ(shared_covariance(SensorPose{}, {1, 1, 0}, ranging), Eigen::Matrix2d::Zero());
  }
}

TEST(SharedCovariance, OfAPlaneIgnoresTheDepthScale) {
  SensorPose pose = sensor_beside(0).pose;
  pose.covariance(6, 6) = 1;
  EXPECT_LT(shared_covariance(pose, {1, 1, 0}, Ranging::plane).norm(), 1e-12);
  EXPECT_GT(shared_covariance(pose, {1, 1, 0}, Ranging::depth).norm(), 1);
}

TEST(SharedErrors, AreZeroForSensorsThatDoNotExist) {
  const SharedErrors errors = robot_errors({uncertain_sensor()}, {0, 0});
  EXPECT_GT(errors[0].norm(), 0);
  for (std::size_t i = 1; i < kMostSensors; ++i) EXPECT_EQ(errors[i], Eigen::Matrix2d::Zero());
}

TEST(SharedErrors, FollowTheWayInWhichASensorFindsTheThing) {
  const std::vector<Sensor> sensors{uncertain_sensor()};
  EXPECT_EQ(ball_errors(sensors, {1, 0})[0], shared_covariance(sensors[0].pose, {1, 0, 0.05}, Ranging::plane));
  EXPECT_EQ(robot_errors(sensors, {1, 0})[0], shared_covariance(sensors[0].pose, {1, 0, 0.3}, Ranging::depth));
}

}  // namespace
}  // namespace robot::truth
