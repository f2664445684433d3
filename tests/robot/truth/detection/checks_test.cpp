#include "robot/truth/detection/checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robot/truth/detection/detector.h"
#include "tests/robot/truth/synthetic/hall.h"

namespace robot::truth {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string error_of(const Result<void>& result) { return result ? "" : result.error(); }

TEST(Checks, APoseOfASensorIsRight) { EXPECT_EQ(error_of(check(mast(kField2012))), ""); }

TEST(Checks, ANumberThatIsNoneInAPoseIsOneSentence) {
  SensorPose pose = mast(kField2012);
  pose.field_from_sensor.translation().x() = kNan;
  EXPECT_EQ(error_of(check(pose)), "pose of the sensor: x [m] must be -100 .. 100, got nan");
  pose = mast(kField2012);
  pose.field_from_sensor.linear()(0, 0) = kNan;
  EXPECT_EQ(error_of(check(pose)), "pose of the sensor: expected a rotation, got a matrix that is none");
  pose = mast(kField2012);
  pose.depth_scale = kNan;
  EXPECT_EQ(error_of(check(pose)), "pose of the sensor: depth scale must be 0.5 .. 2, got nan");
  pose = mast(kField2012);
  pose.intrinsics.focal_x = 0;
  EXPECT_EQ(error_of(check(pose)), "pose of the sensor: focal length x [px] must be 8 .. 100000, got 0");
}

TEST(Checks, AMirroredPoseIsNoRotation) {
  SensorPose pose = mast(kField2012);
  pose.field_from_sensor.linear().col(0) *= -1;
  EXPECT_EQ(error_of(check(pose)), "pose of the sensor: expected a rotation, got a matrix that is none");
}

TEST(Checks, AnImpossibleFieldOrOptionIsOneSentence) {
  sim::field::Field field = kField2012;
  field.length = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error_of(check(field)), "field: length must be 2 .. 30 [m], got nan");
  EXPECT_EQ(error_of(check(DetectorOptions{.ball_radius = -1})),
            "detection: ball radius [m] must be 0.01 .. 0.2, got -1");
}

TEST(Checks, ADetectorIsNotMadeOfBadInput) {
  SensorPose pose = mast(kField2012);
  pose.field_from_sensor.translation().z() = kNan;
  EXPECT_FALSE(Detector::create(pose, kField2012));
  EXPECT_FALSE(Detector::create(mast(kField2012), {}));
  EXPECT_FALSE(Detector::create(mast(kField2012), kField2012, {.robot_height = kNan}));
}

TEST(Checks, AnImageThatDoesNotFitIsOneSentence) {
  DepthFrame frame;
  frame.depth.resize(640 * 480);
  EXPECT_EQ(error_of(check(frame, {})), "");
  EXPECT_EQ(error_of(check(frame, kSmall)),
            "depth image: the pose of the sensor is for 160 x 120 pixels, got 640 x 480");
  frame.rgb.resize(7);
  EXPECT_EQ(error_of(check(frame, {})), "depth image: expected 921600 bytes of colours or none, got 7");
  frame.rgb.clear();
  frame.unit = kNan;
  EXPECT_EQ(error_of(check(frame, {})), "depth image: unit [m] must be 1e-05 .. 0.1, got nan");
  frame.depth.pop_back();
  EXPECT_EQ(error_of(check(frame, {})), "depth image: expected 307200 depths, got 307199");
}

}  // namespace
}  // namespace robot::truth
