#include "robot/truth/detection/detector.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/detection/watched.h"

namespace robot::truth {
namespace {

Scene game() {
  Scene scene;
  scene.robots = {{.x = 0.4, .y = -0.5, .heading = 1}, {.x = -0.8, .y = 0.6}, {.x = 1.1, .y = 1.2, .heading = 2}};
  scene.ball = SceneBall{.x = 0.1, .y = 0.1};
  return scene;
}

void expect_same(const Detections& a, const Detections& b, double error) {
  ASSERT_EQ(a.robots.size(), b.robots.size());
  for (const SeenRobot& robot : a.robots)
    EXPECT_LE(nearest_robot(b, robot.place.position.x(), robot.place.position.y()), error);
  ASSERT_TRUE(a.ball && b.ball);
  EXPECT_LE((a.ball->place.position - b.ball->place.position).norm(), error);
}

TEST(Detector, OfAnEmptyFieldSeesNothing) {
  Watched watched;
  const Detections seen = watched.see(Scene{});
  EXPECT_TRUE(seen.robots.empty());
  EXPECT_FALSE(seen.ball);
}

TEST(Detector, HandsOnTheCaptureTimeAndLeavesTheTimeOfDetectionToItsCaller) {
  Watched watched;
  DepthFrame frame = watched.frame(game());
  frame.capture_ns = 123;
  EXPECT_EQ(watched.see(frame).capture_ns, 123U);
  EXPECT_EQ(watched.see(frame).detected_ns, 0U);
}

TEST(Detector, SeesNothingInAnImageOfOneValue) {
  for (const bool orange_ball : {true, false}) {
    Watched watched(mast(kField2012, -1, 0, kHalf), {.orange_ball = orange_ball});
    for (const int depth : {0, 1, 2047, 65535}) {
      DepthFrame frame;
      frame.intrinsics = kHalf;
      frame.depth.assign(320 * 240, static_cast<std::uint16_t>(depth));
      const Detections seen = watched.see(frame);
      // a board before the sensor, or far behind the field
      EXPECT_TRUE(seen.robots.empty()) << depth;
      EXPECT_FALSE(seen.ball) << depth;
    }
  }
}

TEST(Detector, RefusesAnImageOfAnotherSize) {
  Watched watched;
  DepthFrame frame;
  frame.intrinsics = kSmall;
  frame.depth.resize(160 * 120);
  const std::string sentence = "depth image: the pose of the sensor is for 320 x 240 pixels, got 160 x 120";
  const Result<Detections> seen = watched.detector().detect(frame);
  ASSERT_FALSE(seen);
  EXPECT_EQ(seen.error(), sentence);
  const Result<void> learned = watched.detector().learn_background(frame);
  ASSERT_FALSE(learned);
  EXPECT_EQ(learned.error(), sentence);
}

TEST(Detector, TheSameImageGivesTheSameDetections) {
  Watched watched;
  const DepthFrame frame = watched.frame(game());
  const Detections first = watched.see(frame);
  watched.see(Scene{.robots = {{.x = 0.4, .y = -0.5}}, .people = {{.x = 1, .y = 1}}});
  expect_same(first, watched.see(frame), 0);
}

/// Returns an image as a sensor in a mirrored world takes it.
DepthFrame mirrored(const DepthFrame& frame) {
  DepthFrame result = frame;
  const auto width = static_cast<std::size_t>(frame.intrinsics.width);
  for (std::size_t pixel = 0; pixel < frame.depth.size(); ++pixel) {
    const std::size_t other = pixel / width * width + (width - 1 - pixel % width);
    result.depth[other] = frame.depth[pixel];
    for (std::size_t i = 0; i < 3; ++i) result.rgb[3 * other + i] = frame.rgb[3 * pixel + i];
  }
  return result;
}

/// Returns the pose of a sensor in a world that is mirrored at x = 0.
SensorPose mirrored(SensorPose pose) {
  const Eigen::Vector3d mirror(-1, 1, 1);
  pose.intrinsics.centre_x = pose.intrinsics.width - pose.intrinsics.centre_x;
  const Eigen::Matrix3d turned = mirror.asDiagonal() * pose.field_from_sensor.linear() * mirror.asDiagonal();
  pose.field_from_sensor.linear() = turned;
  pose.field_from_sensor.translation().x() *= -1;
  return pose;
}

TEST(Detector, OfAMirroredWorldSeesItMirrored) {
  for (const bool orange_ball : {true, false}) {
    const SensorPose pose = looking({-0.4, -3.2, 2.1}, {0.3, 0.2, 0}, kHalf);
    Watched watched(pose, {.orange_ball = orange_ball, .colour_shift_x = 1});
    Watched other(mirrored(pose), {.orange_ball = orange_ball, .colour_shift_x = -1});
    const DepthFrame frame = watched.frame(game());
    Detections seen = watched.see(frame);
    EXPECT_EQ(seen.robots.size(), 3U);
    EXPECT_TRUE(seen.ball);
    for (SeenRobot& robot : seen.robots) robot.place.position.x() *= -1;
    if (seen.ball) seen.ball->place.position.x() *= -1;
    // cells and tiles lie the other way round
    expect_same(seen, other.see(mirrored(frame)), 0.003);
  }
}

TEST(Detector, AcceptsAnyUnit) {
  Watched watched;
  DepthFrame frame = watched.frame(game());
  const Detections seen = watched.see(frame);
  for (std::uint16_t& depth : frame.depth) depth = static_cast<std::uint16_t>(4 * depth);
  frame.unit = 0.00025;
  expect_same(seen, watched.see(frame), 0.003);
}

TEST(Detector, UsesTheScaleOfThePose) {
  SensorPose pose = mast(kField2012, -1, 0, kHalf);
  pose.depth_scale = 1.03;
  Watched watched(pose);
  const Detections seen = watched.see(game());
  ASSERT_EQ(seen.robots.size(), 3U);
  for (const SceneRobot& robot : game().robots) EXPECT_LT(nearest_robot(seen, robot.x, robot.y), 0.035);
  EXPECT_TRUE(seen.ball);
}

TEST(Detector, WorksOnASensorWithoutDisparity) {
  Intrinsics time_of_flight = kHalf;
  time_of_flight.baseline = 0;
  const SensorPose pose = mast(kField2012, -1, 0, time_of_flight);
  Watched watched(pose);
  const Detections seen = watched.see(game());
  ASSERT_EQ(seen.robots.size(), 3U);
  for (const SceneRobot& robot : game().robots) EXPECT_LT(nearest_robot(seen, robot.x, robot.y), 0.035);
}

TEST(Detector, SurvivesAnImageOfNoise) {
  for (const bool orange_ball : {true, false}) {
    Watched watched(mast(kField2012, -1, 0, kHalf), {.orange_ball = orange_ball});
    DepthFrame frame;
    frame.intrinsics = kHalf;
    frame.depth.resize(320 * 240);
    frame.rgb.resize(3 * frame.depth.size());
    std::uint32_t state = 1;
    const auto next = [&] { return (state = state * 1664525 + 1013904223) >> 16; };
    for (std::uint16_t& depth : frame.depth) depth = static_cast<std::uint16_t>(next() % 6000);
    for (std::uint8_t& colour : frame.rgb) colour = static_cast<std::uint8_t>(next());
    EXPECT_LT(watched.see(frame).robots.size(), 1000U);
  }
}

}  // namespace
}  // namespace robot::truth
