#include "robot/app/truth/sensor_messages.h"

#include <gtest/gtest.h>

namespace robot::app {
namespace {

truth::DepthFrame small_frame() {
  truth::DepthFrame frame;
  frame.intrinsics = {.width = 2, .height = 2, .focal_x = 3, .focal_y = 4, .centre_x = 1, .centre_y = 1.5};
  frame.depth = {0, 1000, 2345, 65535};
  frame.capture_ns = 7'000'000'012;
  return frame;
}

TEST(SensorMessages, DepthsAreMillimetresInLittleEndian) {
  ::foxglove::RawImage image;
  to_proto(small_frame(), "truth 1", image);
  EXPECT_EQ(image.encoding(), "16UC1");
  EXPECT_EQ(image.width(), 2u);
  EXPECT_EQ(image.height(), 2u);
  EXPECT_EQ(image.step(), 4u);
  EXPECT_EQ(image.frame_id(), "truth 1");
  EXPECT_EQ(image.timestamp().seconds(), 7);
  EXPECT_EQ(image.timestamp().nanos(), 12);
  EXPECT_EQ(image.data(), std::string("\x00\x00\xe8\x03\x29\x09\xff\xff", 8));
}

TEST(SensorMessages, DepthsOfAnotherUnitAreConvertedAndTooFarOnesAreNotMeasured) {
  truth::DepthFrame frame = small_frame();
  frame.unit = 0.002;
  ::foxglove::RawImage image;
  to_proto(frame, "truth 1", image);
  EXPECT_EQ(image.data(), std::string("\x00\x00\xd0\x07\x52\x12\x00\x00", 8));
}

TEST(SensorMessages, ColoursAreSentOnlyWhereThereAreSome) {
  truth::DepthFrame frame = small_frame();
  ::foxglove::RawImage image;
  EXPECT_FALSE(colour_to_proto(frame, "truth 1", image));
  frame.rgb.assign(12, 200);
  ASSERT_TRUE(colour_to_proto(frame, "truth 1", image));
  EXPECT_EQ(image.encoding(), "rgb8");
  EXPECT_EQ(image.step(), 6u);
  EXPECT_EQ(image.data().size(), 12u);
}

TEST(SensorMessages, ThePlaceIsTheRotationRowByRow) {
  truth::SensorPose pose;
  pose.field_from_sensor.linear() << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  pose.field_from_sensor.translation() = Eigen::Vector3d(1, -3, 2);
  pose.depth_scale = 1.01;
  pb::TruthSensor::SensorPlace place;
  to_proto(pose, place);
  ASSERT_EQ(place.rotation_size(), 9);
  EXPECT_EQ(place.rotation(1), 1);
  EXPECT_EQ(place.rotation(3), -1);
  EXPECT_EQ(place.y(), -3);
  EXPECT_FLOAT_EQ(place.depth_scale(), 1.01f);
}

TEST(SensorMessages, AMissingBallStaysMissing) {
  truth::Detections detections;
  detections.robots.push_back({.place = {.position = {1, 2}}, .heading = 0.5, .team = 14, .player = 3});
  pb::TruthSensor message;
  message.mutable_ball()->set_x(3);
  to_proto(detections, message);
  EXPECT_FALSE(message.has_ball());
  ASSERT_EQ(message.robots_size(), 1);
  EXPECT_EQ(message.robots(0).player(), 3u);
  EXPECT_FLOAT_EQ(message.robots(0).heading(), 0.5f);
  EXPECT_FLOAT_EQ(message.robots(0).covariance().xx(), 1);
  detections.ball = truth::SeenBall{.place = {.position = {-1, 0.25}}};
  to_proto(detections, message);
  EXPECT_EQ(message.ball().y(), 0.25f);
}

}  // namespace
}  // namespace robot::app
