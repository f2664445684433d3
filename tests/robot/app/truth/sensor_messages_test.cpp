#include "robot/app/truth/sensor_messages.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(SensorMessages, RefusedTagsAreCountedByTheirReasons) {
  pb::TruthSensor::RefusedTags message;
  to_proto({.unknown = 1, .repeated = 2, .implausible = 3, .contradictory = 4}, message);
  EXPECT_EQ(message.unknown(), 1u);
  EXPECT_EQ(message.repeated(), 2u);
  EXPECT_EQ(message.implausible(), 3u);
  EXPECT_EQ(message.contradictory(), 4u);
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

truth::Detections two_robots_and_a_ball() {
  truth::Detections seen{.capture_ns = 7};
  const Eigen::Matrix2d covariance{{4e-4, 1e-4}, {1e-4, 9e-4}};
  seen.robots.push_back({.place = {.position = {1.25, -2}, .covariance = covariance}, .height = 0.5});
  seen.robots.push_back({.place = {.position = {-1, 2}, .covariance = covariance},
                         .heading = 0.5,
                         .heading_deviation = 0.25,
                         .team = 14,
                         .player = 3});
  seen.ball = truth::SeenBall{.place = {.position = {0.5, 0.25}, .covariance = covariance}};
  return seen;
}

TEST(SensorMessages, DetectionsComeBackAsTheyWere) {
  pb::TruthSensor message;
  to_proto(two_robots_and_a_ball(), message);
  const truth::Detections back = detections_of(message, 7);
  const truth::Detections seen = two_robots_and_a_ball();
  EXPECT_EQ(back.capture_ns, 7u);
  ASSERT_EQ(back.robots.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.robots[i].place.position, seen.robots[i].place.position);
    EXPECT_TRUE(back.robots[i].place.covariance.isApprox(seen.robots[i].place.covariance, 1e-6));
    EXPECT_EQ(back.robots[i].height, seen.robots[i].height);
    EXPECT_EQ(back.robots[i].heading, seen.robots[i].heading);
    EXPECT_EQ(back.robots[i].heading_deviation, seen.robots[i].heading_deviation);
    EXPECT_EQ(back.robots[i].team, seen.robots[i].team);
    EXPECT_EQ(back.robots[i].player, seen.robots[i].player);
  }
  ASSERT_TRUE(back.ball);
  EXPECT_EQ(back.ball->place.position, seen.ball->place.position);
  EXPECT_FALSE(detections_of({}, 7).ball);
}

pb::TruthSensor placed(const truth::SensorPose& pose) {
  pb::TruthSensor message;
  to_proto(pose.intrinsics, *message.mutable_pinhole());
  to_proto(pose, *message.mutable_place());
  return message;
}

TEST(SensorMessages, APoseComesBackWithItsErrors) {
  truth::SensorPose pose;
  pose.intrinsics.focal_x = 580.5;
  pose.field_from_sensor.linear() << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  pose.field_from_sensor.translation() = Eigen::Vector3d(1, -3, 2);
  pose.depth_scale = 1.25;
  EXPECT_EQ(placed(pose).place().covariance_size(), 0) << "it is exact";
  for (int row = 0; row < 7; ++row)
    for (int column = 0; column < 7; ++column) pose.covariance(row, column) = 1. / (1 << (row + column));
  const auto back = pose_of(placed(pose));
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->intrinsics.focal_x, 580.5);
  EXPECT_TRUE(back->field_from_sensor.isApprox(pose.field_from_sensor));
  EXPECT_EQ(back->depth_scale, 1.25);
  EXPECT_EQ(back->covariance, pose.covariance);
}

TEST(SensorMessages, NumbersThatAreNoPoseAreRefused) {
  const pb::TruthSensor good = placed({});
  ASSERT_TRUE(pose_of(good));
  pb::TruthSensor wrong = good;
  wrong.mutable_place()->mutable_rotation()->RemoveLast();
  EXPECT_EQ(pose_of(wrong).error(), "its place has a rotation of 8 numbers, expected 9");
  wrong = good;
  wrong.mutable_place()->add_covariance(1);
  EXPECT_EQ(pose_of(wrong).error(), "its place has a covariance of 1 numbers, expected 28 or none");
  for (const auto spoil : {+[](pb::TruthSensor::SensorPlace& place) { place.set_rotation(0, 2); },
                           +[](pb::TruthSensor::SensorPlace& place) { place.set_rotation(0, -1); },
                           +[](pb::TruthSensor::SensorPlace& place) { place.set_x(std::nanf("")); }}) {
    wrong = good;
    spoil(*wrong.mutable_place());
    EXPECT_EQ(pose_of(wrong).error(), "its place is no pose");
  }
  EXPECT_FALSE(pose_of({}));
}

}  // namespace
}  // namespace robot::app
