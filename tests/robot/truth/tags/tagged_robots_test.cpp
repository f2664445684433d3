#include "robot/truth/tags/tagged_robots.h"

#include <gtest/gtest.h>

#include <numbers>

#include "robot/truth/tags/tag_pose.h"
#include "tests/support/camera_above.h"

namespace {

using robot::truth::SeenRobot;
using robot::truth::tags::Camera;
using robot::truth::tags::corners_in_picture;
using robot::truth::tags::Mounting;
using robot::truth::tags::RefusedTags;
using robot::truth::tags::SeenTag;
using robot::truth::tags::tagged_robots;
using robot::truth::tags::TagPlan;
using tests::flat_tag;
using tests::kDegree;

constexpr Mounting kHead{.edge = 0.14, .height = 0.5};

/// A camera, a plan with one head tag of robot 5/2, and the result of the last call.
class TaggedRobots : public testing::Test {
 protected:
  TaggedRobots() { plan.tags[3] = {.team = 5, .player = 2, .mounting = kHead}; }

  SeenTag tag(int id, const Eigen::Isometry3d& pose, double edge = kHead.edge) const {
    return {.id = id, .margin = 60, .corners = *corners_in_picture(camera, pose, edge)};
  }
  std::vector<SeenRobot> robots(const std::vector<SeenTag>& tags) { return tagged_robots(camera, plan, tags, refused); }

  Camera camera = tests::camera_above({-1.5, 0, 2.8}, {0, 0}, {1280, 720}, 700);
  TagPlan plan;
  RefusedTags refused;
};

TEST_F(TaggedRobots, AStandingRobotHasPlaceHeadingHeightAndIdentity) {
  const auto seen = robots({tag(3, flat_tag({0.5, 0.2, 0.5}, 1))});
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_LT((seen[0].place.position - Eigen::Vector2d(0.5, 0.2)).norm(), 1e-6);
  EXPECT_NEAR(*seen[0].heading, 1, 1e-6);
  EXPECT_LT(*seen[0].heading_deviation, 2 * kDegree);
  EXPECT_NEAR(seen[0].height, 0.5, 1e-6);
  EXPECT_EQ(seen[0].team, 5u);
  EXPECT_EQ(seen[0].player, 2u);
}

TEST_F(TaggedRobots, TheMountingIsTakenOff) {
  plan.tags[3].mounting = {.edge = 0.14, .height = 0.5, .forward = 0.1, .left = 0.05, .turn = 90 * kDegree};
  // a robot at (0.5, 0.2) that looks to +y: ahead is +y, left is -x
  const auto seen = robots({tag(3, flat_tag({0.45, 0.3, 0.5}, 180 * kDegree))});
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_LT((seen[0].place.position - Eigen::Vector2d(0.5, 0.2)).norm(), 1e-6);
  EXPECT_NEAR(*seen[0].heading, 90 * kDegree, 1e-6);
}

TEST_F(TaggedRobots, TheMirroredSceneGivesTheMirroredTruth) {
  // the camera is on the mirror y = 0
  const auto one = robots({tag(3, flat_tag({0.5, 0.7, 0.5}, 1))});
  const auto other = robots({tag(3, flat_tag({0.5, -0.7, 0.5}, -1))});
  ASSERT_EQ(one.size() + other.size(), 2u);
  EXPECT_NEAR(one[0].place.position.x(), other[0].place.position.x(), 1e-6);
  EXPECT_NEAR(one[0].place.position.y(), -other[0].place.position.y(), 1e-6);
  EXPECT_NEAR(*one[0].heading, -*other[0].heading, 1e-6);
  EXPECT_NEAR(one[0].place.covariance(0, 0), other[0].place.covariance(0, 0), 1e-8);
  EXPECT_NEAR(one[0].place.covariance(0, 1), -other[0].place.covariance(0, 1), 1e-8);
}

TEST_F(TaggedRobots, ALyingRobotIsLowAndHasNoHeading) {
  Eigen::Isometry3d pose = flat_tag({0.5, 0.2, 0.1}, -90 * kDegree);
  pose.linear() = Eigen::AngleAxisd(-80 * kDegree, Eigen::Vector3d::UnitY()) * pose.linear();  // towards the camera
  const auto seen = robots({tag(3, pose)});
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_LT((seen[0].place.position - Eigen::Vector2d(0.5, 0.2)).norm(), 1e-3);
  EXPECT_NEAR(seen[0].height, 0.1, 1e-3);
  EXPECT_FALSE(seen[0].heading);
  EXPECT_EQ(seen[0].player, 2u);
}

TEST_F(TaggedRobots, UnknownIdsAreIgnoredAndCounted) {
  EXPECT_TRUE(robots({tag(4, flat_tag({0.5, 0.2, 0.5}, 1)), tag(5, flat_tag({0, 0, 0.5}, 1))}).empty());
  EXPECT_EQ(refused.unknown, 2u);
}

TEST_F(TaggedRobots, AnIdThatIsThereTwiceGivesNoRobot) {
  EXPECT_TRUE(robots({tag(3, flat_tag({0.5, 0.2, 0.5}, 1)), tag(3, flat_tag({0, 0, 0.5}, 1))}).empty());
  EXPECT_EQ(refused.repeated, 2u);
}

TEST_F(TaggedRobots, ACarriedRobotIsRefusedAndCounted) {
  EXPECT_TRUE(robots({tag(3, flat_tag({0.5, 0.2, 1.1}, 1))}).empty());
  EXPECT_EQ(refused.implausible, 1u);
}

TEST_F(TaggedRobots, ATagOfAnotherSizeThanPlannedIsRefusedAndCounted) {
  EXPECT_TRUE(robots({tag(3, flat_tag({0.5, 0.2, 0.5}, 1), 0.12)}).empty());
  EXPECT_EQ(refused.implausible, 1u);
}

TEST_F(TaggedRobots, AHiddenCornerGivesNothingRatherThanSomethingWrong) {
  for (std::size_t corner = 0; corner < 4; ++corner) {
    SeenTag hidden = tag(3, flat_tag({0.5, 0.2, 0.5}, 1));
    const Eigen::Vector2d middle = (hidden.corners[0] + hidden.corners[2]) / 2;
    hidden.corners[corner] += 0.25 * (middle - hidden.corners[corner]);
    EXPECT_TRUE(robots({hidden}).empty()) << corner;
  }
  EXPECT_EQ(refused.implausible, 4u);
}

TEST_F(TaggedRobots, TwoTagsOfARobotGiveOneMoreExactRobot) {
  plan.tags[3].mounting.left = 0.1;
  plan.tags[8] = {.team = 5, .player = 2, .mounting = {.edge = 0.14, .height = 0.5, .left = -0.1}};
  const SeenTag left = tag(3, flat_tag({0.5, 0.3, 0.5}, 0)), right = tag(8, flat_tag({0.5, 0.1, 0.5}, 0));
  const auto one = robots({left}), both = robots({left, right});
  ASSERT_EQ(both.size(), 1u);
  EXPECT_LT((both[0].place.position - Eigen::Vector2d(0.5, 0.2)).norm(), 1e-6);
  EXPECT_LT(both[0].place.covariance.trace(), 0.7 * one[0].place.covariance.trace());
  EXPECT_LT(*both[0].heading_deviation, 0.8 * *one[0].heading_deviation);
}

TEST_F(TaggedRobots, TwoTagsOfARobotAtDifferentPlacesGiveNone) {
  plan.tags[8] = plan.tags[3];
  EXPECT_TRUE(robots({tag(3, flat_tag({0.5, 0.3, 0.5}, 0)), tag(8, flat_tag({0.5, -0.3, 0.5}, 0))}).empty());
  EXPECT_EQ(refused.contradictory, 2u);
}

}  // namespace
