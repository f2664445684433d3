#include "robot/app/truth/truth_writer.h"

#include <gtest/gtest.h>

#include "robot/truth/synthetic/sensor_poses.h"

namespace robot::app {
namespace {

constexpr std::uint64_t kFirstNs = 5'000'000'000;

/// The image of a sensor that sees one robot.
truth::Detections seen_at(double x, std::uint64_t capture_ns) {
  truth::Detections detections{.capture_ns = capture_ns, .detected_ns = capture_ns + 2};
  truth::SeenRobot robot{.height = 0.57};
  robot.place.position = {x, 0.5};
  robot.place.covariance = Eigen::Matrix2d::Identity() * 1e-4;
  detections.robots.push_back(robot);
  return detections;
}

class Truth : public testing::Test {
 protected:
  Truth() { world.announce("/truth/world", memory::Delivery::latest, clock); }

  void calibrate(TruthWriter& writer, std::size_t sensor) const {
    writer.place(sensor, {.pose = truth::looking({0, sensor == 0 ? -4.0 : 4.0, 2}, {0, 0, 0})});
  }
  std::uint64_t written() const { return world.read() ? world.read()->sequence() : 0; }

  ManualClock clock{kFirstNs + 100};
  memory::MemoryObject<foresight::GroundTruth> world;
};

TEST_F(Truth, OneSensorIsWrittenWithEachImage) {
  TruthWriter writer(1, clock, world);
  calibrate(writer, 0);
  for (std::uint64_t image = 0; image < 10; ++image) {
    const std::uint64_t capture_ns = kFirstNs + image * kSecond / 30;
    writer.add(0, seen_at(1, capture_ns));
    EXPECT_EQ(written(), image + 1);
    EXPECT_EQ(world.read()->capture_ns(), capture_ns);
  }
  const auto newest = world.read();
  ASSERT_EQ(newest->value().robots_size(), 1);
  const auto& robot = newest->value().robots(0);
  EXPECT_NEAR(robot.x(), 1, 0.02);
  EXPECT_TRUE(robot.has_track());
  EXPECT_FALSE(robot.has_team());
  EXPECT_GT(robot.covariance().xx(), 0);
  EXPECT_EQ(robot.sensors(), 1u);
  EXPECT_EQ(newest->value().detected_ns(), newest->capture_ns() + 2);
  EXPECT_EQ(newest->value().sent_ns(), clock.now_ns());
}

TEST_F(Truth, TwoSensorsAreWrittenTogether) {
  TruthWriter writer(2, clock, world);
  calibrate(writer, 0);
  calibrate(writer, 1);
  const auto both = [&](std::uint64_t image) {
    writer.add(0, seen_at(1, kFirstNs + image * kSecond / 30));
    writer.add(1, seen_at(1, kFirstNs + image * kSecond / 30 + 5'000'000));
  };
  both(0);  // the first image of the first sensor is written alone: the second one has not begun
  const std::uint64_t begun = written();
  for (std::uint64_t image = 1; image < 10; ++image) both(image);
  EXPECT_EQ(written(), begun + 9);
  EXPECT_EQ(world.read()->value().robots(0).sensors(), 2u);
}

TEST_F(Truth, NobodyWaitsForALostSensor) {
  TruthWriter writer(2, clock, world);
  calibrate(writer, 0);
  calibrate(writer, 1);
  writer.add(0, seen_at(1, kFirstNs));
  writer.add(1, seen_at(1, kFirstNs + 1));
  writer.lost(1);
  const std::uint64_t before = written();
  for (std::uint64_t image = 1; image < 4; ++image) {
    writer.add(0, seen_at(1, kFirstNs + image * kSecond / 30));
    EXPECT_EQ(written(), before + image);
  }
}

TEST_F(Truth, ASlowSensorDelaysTheOtherByOneImageAtMost) {
  TruthWriter writer(2, clock, world);
  calibrate(writer, 0);
  calibrate(writer, 1);
  writer.add(0, seen_at(1, kFirstNs));
  writer.add(1, seen_at(1, kFirstNs + 1));
  const std::uint64_t before = written();
  for (std::uint64_t image = 1; image < 5; ++image) writer.add(0, seen_at(1, kFirstNs + image * kSecond / 30));
  EXPECT_GE(written(), before + 3);
}

TEST_F(Truth, AnUncalibratedSensorIsNotUsed) {
  TruthWriter writer(1, clock, world);
  writer.add(0, seen_at(1, kFirstNs));
  EXPECT_EQ(written(), 0u);
}

TEST_F(Truth, AnOwnPoseNamesARobot) {
  TruthWriter writer(1, clock, world);
  calibrate(writer, 0);
  for (std::uint64_t image = 0; image < 150; ++image) {
    const std::uint64_t capture_ns = kFirstNs + image * kSecond / 30;
    writer.identify({.capture_ns = capture_ns, .team = 14, .player = 3, .position = {1, 0.5}});
    writer.add(0, seen_at(1, capture_ns));
  }
  const auto newest = world.read();
  ASSERT_EQ(newest->value().robots_size(), 1);
  EXPECT_EQ(newest->value().robots(0).team(), 14u);
  EXPECT_EQ(newest->value().robots(0).player(), 3u);
}

}  // namespace
}  // namespace robot::app
