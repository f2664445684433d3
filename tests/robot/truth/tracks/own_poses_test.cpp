#include "robot/truth/tracks/own_poses.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/robot/truth/tracks/images.h"

namespace robot::truth {
namespace {

OwnPose pose_at(double seconds, std::uint32_t player, double x = 0) {
  return {.capture_ns = at_seconds(seconds), .team = 1, .player = player, .position = {x, 0}, .deviation = 0.2};
}

TEST(OwnPoses, AreFoundByTheNearestTime) {
  OwnPoses poses;
  for (const double t : {0., 0.1, 0.2}) ASSERT_TRUE(poses.add(pose_at(t, 1, t)));
  EXPECT_EQ(poses.players()[0].at(at_seconds(0.12))->position.x(), 0.1);
  EXPECT_EQ(poses.players()[0].at(at_seconds(0.34))->position.x(), 0.2);
  EXPECT_EQ(poses.players()[0].at(at_seconds(0.36)), nullptr);
}

TEST(OwnPoses, KeepTheNewestOnes) {
  OwnPoses poses;
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(poses.add(pose_at(i * 0.01, 1, i)));
  EXPECT_EQ(poses.players()[0].at(at_seconds(9.99))->position.x(), 999);
  EXPECT_EQ(poses.players()[0].at(at_seconds(9.99 - 0.63))->position.x(), 936);
  EXPECT_EQ(poses.players()[0].at(at_seconds(5)), nullptr);
}

TEST(OwnPoses, HaveOneIndexForEachPlayer) {
  OwnPoses poses;
  EXPECT_EQ(poses.find_or_add(1, 1), 0u);
  EXPECT_EQ(poses.find_or_add(2, 1), 1u);
  EXPECT_EQ(poses.find_or_add(1, 1), 0u);
  EXPECT_EQ(poses.find(2, 1), 1u);
  EXPECT_FALSE(poses.find(2, 2));
}

TEST(OwnPoses, RefuseOneThatIsNotValid) {
  OwnPoses poses;
  OwnPose pose = pose_at(0, 3);
  pose.deviation = 0;
  EXPECT_EQ(poses.add(pose).error(),
            "own pose of team 1, player 3: expected a finite place and a deviation > 0 m, got (0, 0) m, 0 m");
  pose = pose_at(0, 3, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(poses.add(pose));
}

TEST(OwnPoses, RefuseTooManyPlayers) {
  OwnPoses poses;
  for (std::uint32_t player = 0; player < kMostPlayers; ++player) ASSERT_TRUE(poses.add(pose_at(0, player)));
  EXPECT_EQ(poses.add(pose_at(0, 99)).error(), "own pose of team 1, player 99: expected at most 32 players in all");
}

}  // namespace
}  // namespace robot::truth
