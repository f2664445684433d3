#include "robot/truth/tracks/identity.h"

#include <gtest/gtest.h>

#include "robot/truth/tracks/tracker.h"
#include "tests/robot/truth/tracks/images.h"

namespace robot::truth {
namespace {

const Eigen::Vector2d kLeft(-1.5, 0.5), kRight(1.5, -0.5), kNowhere(0, 2);

/// Two robots that stand, and the own poses of one player.
class TwoRobots : public testing::Test {
 protected:
  /// Shows both robots for `seconds`, while the player believes to be at `believed`.
  void watch(double seconds, const Eigen::Vector2d& believed, bool left = true, bool right = true) {
    for (const double end = time_ + seconds; time_ < end; time_ += 1. / 30) {
      std::vector<Eigen::Vector2d> robots;
      if (left) robots.push_back(kLeft);
      if (right) robots.push_back(kRight);
      ASSERT_TRUE(tracker_.identify(
          {.capture_ns = at_seconds(time_), .team = 5, .player = 3, .position = believed, .deviation = 0.2}));
      ASSERT_TRUE(tracker_.add(image_of(time_, robots)));
    }
  }

  /// Returns the player of the robot at the place; 0 without one.
  std::uint32_t player_at(const Eigen::Vector2d& place) const {
    for (const FusedRobot& robot : tracker_.truth().robots)
      if ((robot.place.position - place).norm() < 0.1) return robot.player.value_or(0);
    return 0;
  }

  Tracker tracker_{{sensor_beside(0)}};
  double time_ = 0;
};

TEST_F(TwoRobots, ThePlayerIsBoundAfterEnoughEvidence) {
  watch(1, kLeft);
  EXPECT_EQ(player_at(kLeft), 0u);
  watch(3, kLeft);
  EXPECT_EQ(player_at(kLeft), 3u);
  EXPECT_EQ(player_at(kRight), 0u);
}

TEST_F(TwoRobots, AFlippedLocalisationDoesNotSwitchTheIdentity) {
  watch(30, kLeft);
  watch(10, kRight);
  EXPECT_EQ(player_at(kLeft), 3u);
  EXPECT_EQ(player_at(kRight), 0u);
}

TEST_F(TwoRobots, ThePlayerIsReleasedWithTheEvidence) {
  watch(5, kLeft);
  watch(20, kNowhere);
  EXPECT_EQ(player_at(kLeft), 0u);
  EXPECT_EQ(player_at(kRight), 0u);
}

TEST_F(TwoRobots, APlayerThatWasBoundWronglyMovesToItsRobot) {
  watch(4, kRight);
  EXPECT_EQ(player_at(kRight), 3u);
  watch(10, kLeft);
  EXPECT_EQ(player_at(kLeft), 3u);
  EXPECT_EQ(player_at(kRight), 0u);
}

TEST_F(TwoRobots, ThePlayerStaysBoundThroughAShortMiss) {
  watch(5, kLeft);
  watch(0.3, kLeft, /*left=*/false);
  watch(0.1, kLeft);
  EXPECT_EQ(player_at(kLeft), 3u);
}

TEST_F(TwoRobots, AnIdentityInDoubtIsWithheldUntilNewEvidence) {
  watch(5, kLeft);
  watch(1, kLeft, /*left=*/false, /*right=*/false);
  watch(0.1, kLeft);
  EXPECT_EQ(player_at(kLeft), 0u);
  watch(3, kLeft);
  EXPECT_EQ(player_at(kLeft), 3u);
}

TEST_F(TwoRobots, ATagBindsAtOnce) {
  SensorImage image = image_of(0, {kLeft, kRight});
  image.detections.robots[1].team = 5;
  image.detections.robots[1].player = 3;
  for (int i = 0; i < 3; ++i, image.detections.capture_ns += 33'000'000) ASSERT_TRUE(tracker_.add(image));
  EXPECT_EQ(player_at(kRight), 3u);
  // and moves with the tag
  std::swap(image.detections.robots[0].place, image.detections.robots[1].place);
  for (int i = 0; i < 3; ++i, image.detections.capture_ns += 33'000'000) ASSERT_TRUE(tracker_.add(image));
  EXPECT_EQ(player_at(kLeft), 3u);
  EXPECT_EQ(player_at(kRight), 0u);
}

TEST_F(TwoRobots, OneRobotIsOnePlayer) {
  for (int i = 0; i < 300; ++i) {
    for (const std::uint32_t player : {3u, 4u})
      ASSERT_TRUE(tracker_.identify(
          {.capture_ns = at_seconds(i / 30.), .team = 5, .player = player, .position = kLeft, .deviation = 0.2}));
    ASSERT_TRUE(tracker_.add(image_of(i / 30., {kLeft, kRight})));
  }
  const FusedTruth truth = tracker_.truth();
  int named = 0;
  for (const FusedRobot& robot : truth.robots) named += robot.player.has_value();
  EXPECT_EQ(named, 1);
}

TEST(Evidence, OfADistantPoseIsLimited) {
  const OwnPose pose{.capture_ns = 0, .team = 1, .player = 1, .position = {0, 0}, .deviation = 0.2};
  const Eigen::Matrix2d covariance = 4e-4 * Eigen::Matrix2d::Identity();
  EXPECT_GT(evidence_of(pose, {0, 0}, covariance), 4);
  EXPECT_GE(evidence_of(pose, {5, 0}, covariance), -3);
  EXPECT_LT(evidence_of(pose, {5, 0}, covariance), -2.9);
}

}  // namespace
}  // namespace robot::truth
