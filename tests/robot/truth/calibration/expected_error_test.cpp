#include "robot/truth/calibration/expected_error.h"

#include <gtest/gtest.h>

#include "robot/truth/synthetic/sensor_poses.h"
#include "tests/support/ground_picture.h"

namespace robot::truth {
namespace {

View view_of(const Eigen::Isometry3d& field_from_sensor) {
  return {.field_from_sensor = field_from_sensor, .camera = {}};
}

TEST(ExpectedError, IsZeroForAnExactCalibration) {
  const auto error = expected_error(view_of(tests::mast_scene().field_from_sensor), ViewCovariance::Zero(), {3, 2},
                                    MeasuredBy::depth, 0.3);
  EXPECT_GT(error.grid.size(), 40u);
  EXPECT_EQ(error.mean, 0);
  EXPECT_NEAR(error.p95, 0, 1e-12);
}

TEST(ExpectedError, OfAShiftIsRayleighs) {
  ViewCovariance covariance = ViewCovariance::Zero();
  covariance(3, 3) = covariance(4, 4) = 0.01 * 0.01;
  for (const MeasuredBy measurement : {MeasuredBy::depth, MeasuredBy::bearing}) {
    const auto error =
        expected_error(view_of(tests::mast_scene().field_from_sensor), covariance, {3, 2}, measurement, 0.3);
    EXPECT_NEAR(error.mean, 0.01 * std::sqrt(M_PI / 2), 1e-5);
    EXPECT_NEAR(error.p95, 0.01 * 2.4477, 1e-5);
    for (const ErrorAt& at : error.grid) EXPECT_NEAR(at.metres, error.mean, 1e-5);
  }
}

TEST(ExpectedError, OfATurnGrowsWithTheDistance) {
  ViewCovariance covariance = ViewCovariance::Zero();
  covariance(1, 1) = 1e-4;
  const View view = view_of(tests::mast_scene().field_from_sensor);
  const auto near = place_covariance(view, covariance, {0, -1, 0}, MeasuredBy::depth);
  const auto far = place_covariance(view, covariance, {0, 1.5, 0}, MeasuredBy::depth);
  ASSERT_TRUE(near && far);
  EXPECT_GT(far->trace(), 1.5 * near->trace());
}

TEST(ExpectedError, CountsDepthsWithinFiveMetresAndBearingsEverywhere) {
  const View view = view_of(robot::truth::looking({0, -3.2, 2.1}, {0, 0.2, 0}).field_from_sensor);
  const Eigen::Vector2d reach(3, 2.5);
  const auto depth = expected_error(view, ViewCovariance::Zero(), reach, MeasuredBy::depth, 0.3);
  const auto bearing = expected_error(view, ViewCovariance::Zero(), reach, MeasuredBy::bearing, 0.3);
  for (const ErrorAt& at : depth.grid) EXPECT_LE(view.seen({at.x, at.y, 0.3}).z(), kFarthestDepth);
  EXPECT_GT(bearing.grid.size(), depth.grid.size());
}

TEST(ExpectedError, IsEmptyForASensorThatLooksAway) {
  const View view = view_of(robot::truth::looking({0, -3.2, 2.1}, {0, -9, 0}).field_from_sensor);
  const auto error = expected_error(view, ViewCovariance::Identity(), {3, 2}, MeasuredBy::depth, 0.3);
  EXPECT_TRUE(error.grid.empty());
  EXPECT_EQ(error.p95, 0);
}

}  // namespace
}  // namespace robot::truth
