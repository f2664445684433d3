#include "robot/app/truth/robot_poses.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::app {
namespace {

constexpr std::uint64_t kImageNs = 1'700'000'000 * kSecond;

foresight::Pose pose_at(float x, float y) {
  foresight::Pose pose;
  pose.set_x(x);
  pose.set_y(y);
  pose.set_deviation_x(0.3f);
  pose.set_deviation_y(0.4f);
  return pose;
}

foresight::GameState playing_towards(bool positive_x) {
  foresight::GameState game;
  game.set_attacks_positive_x(positive_x);
  return game;
}

TEST(OwnPose, IsTurnedWithTheDirectionOfPlay) {
  const auto straight = own_pose_of({14, 2}, pose_at(1, -2), playing_towards(true), 7);
  ASSERT_TRUE(straight);
  EXPECT_EQ(straight->position, Eigen::Vector2d(1, -2));
  EXPECT_EQ(straight->team, 14u);
  EXPECT_EQ(straight->player, 2u);
  EXPECT_EQ(straight->capture_ns, 7u);
  EXPECT_NEAR(straight->deviation, 0.354, 0.001);
  const auto turned = own_pose_of({14, 2}, pose_at(1, -2), playing_towards(false), 7);
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->position, Eigen::Vector2d(-1, 2));
}

TEST(OwnPose, IsNotUsedWithoutADirectionOfPlayOrWithWrongNumbers) {
  EXPECT_FALSE(own_pose_of({14, 2}, pose_at(1, -2), {}, 7));
  EXPECT_FALSE(own_pose_of({14, 2}, pose_at(std::nanf(""), -2), playing_towards(true), 7));
}

TEST(OwnPose, OfASureRobotIsStillDoubted) {
  foresight::Pose sure = pose_at(1, 1);
  sure.set_deviation_x(0);
  sure.set_deviation_y(0);
  EXPECT_EQ(own_pose_of({14, 2}, sure, playing_towards(true), 7)->deviation, 0.1);
}

/// A robot whose objects arrive, and the tracks of a sensor that sees two robots.
struct LiveRobot : testing::Test {
  LiveRobot() {
    world.announce(memory::kTruthTopic, memory::Delivery::latest, clock);
    pose->announce("/14/2/pose", memory::Delivery::latest, clock);
    game->announce("/14/2/game", memory::Delivery::latest, clock);
    EXPECT_TRUE(channels.add(pose));
    EXPECT_TRUE(channels.add(game));
    truth::Sensor sensor;
    sensor.pose.field_from_sensor.translation() = Eigen::Vector3d(0, 0, 3);
    writer.place(0, sensor);
  }

  void see_image(std::uint64_t image_ns) {
    truth::Detections seen{.capture_ns = image_ns, .detected_ns = image_ns + kMillisecond};
    for (const double side : {-1., 1.})
      seen.robots.push_back(
          {.place = {.position = {side, 0.5 * side}, .covariance = 1e-4 * Eigen::Matrix2d::Identity()}, .height = 0.5});
    writer.add(0, seen);
  }

  const ManualClock clock{kImageNs};
  memory::MemoryObject<foresight::GroundTruth> world;
  std::shared_ptr<memory::MemoryObject<foresight::Pose>> pose =
      std::make_shared<memory::MemoryObject<foresight::Pose>>();
  std::shared_ptr<memory::MemoryObject<foresight::GameState>> game =
      std::make_shared<memory::MemoryObject<foresight::GameState>>();
  memory::Channels channels;
  TruthWriter writer{1, clock, world};
  RobotPoses poses{channels, writer};
};

TEST_F(LiveRobot, IsNamedInTheTruth) {
  game->write(playing_towards(false), kImageNs);
  for (std::uint64_t image = 0; image < 150; ++image) {
    const std::uint64_t image_ns = kImageNs + image * kSecond / 30;
    pose->write(pose_at(1, 0.5), image_ns);  // of the robot at -1, -0.5 in the field
    poses.pass_on();
    see_image(image_ns);
  }
  const auto newest = world.read();
  ASSERT_EQ(newest->value().robots_size(), 2);
  for (const auto& robot : newest->value().robots()) {
    EXPECT_EQ(robot.has_player(), robot.x() < 0);
    EXPECT_EQ(robot.player(), robot.x() < 0 ? 2u : 0u);
  }
}

TEST_F(LiveRobot, AnOldPoseIsPassedOnOnce) {
  game->write(playing_towards(false), kImageNs);
  pose->write(pose_at(1, 0.5), kImageNs);
  for (std::uint64_t image = 0; image < 150; ++image) {
    poses.pass_on();
    see_image(kImageNs + image * kSecond / 30);
  }
  for (const auto& robot : world.read()->value().robots()) EXPECT_FALSE(robot.has_player());
}

}  // namespace
}  // namespace robot::app
