#include "robot/lab/clocks/own_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace robot::lab {
namespace {

/// A robot that walks on a circle around a place.
PlaceAt circling(double at, double x, double y) {
  return {.at = at, .x = x + std::cos(at / 8), .y = y + std::sin(at / 8)};
}

Path circle(double x, double y, double from = 0, double to = 60) {
  Path path;
  for (double at = from; at < to; at += 1 / 30.0) path.push_back(circling(at, x, y));
  return path;
}

/// The poses of a robot on that circle by a clock that is ahead, turned by half a circle if `turned`.
RobotRecord posed(double x, double y, double ahead, bool turned) {
  RobotRecord robot{.name = "14/2", .balls = {}, .poses = {}, .sightings = {}, .ranges = {}};
  for (const PlaceAt& place : circle(x, y))
    robot.poses.push_back({.at = place.at + ahead,
                           .x = turned ? -place.x : place.x,
                           .y = turned ? -place.y : place.y,
                           .heading = turned ? std::numbers::pi : 0});
  return robot;
}

TruthRecord truth_with(std::vector<TrueRobotPath> robots) {
  TruthRecord truth;
  truth.robots = std::move(robots);
  return truth;
}

constexpr LagRange kRange{.middle = 0, .reach = 5};

TEST(OwnPath, ItsNumberDecides) {
  const auto own =
      own_path(truth_with({{"14/1", circle(1, 1)}, {"14/2", circle(-2, 0)}}), posed(1, 1, 0, false), kRange);
  ASSERT_TRUE(own);
  EXPECT_EQ(own->name, "14/2");
  EXPECT_EQ(own->by, "its number");
  EXPECT_TRUE(own->poses.empty()) << "its poses fit another path";
}

TEST(OwnPath, WithoutNumbersThePoseDecidesOnBothSides) {
  for (const bool turned : {false, true}) {
    const auto own = own_path(truth_with({{"track 3", circle(1, 1)}, {"track 4", circle(-2, 0)}}),
                              posed(-2, 0, 1.5, turned), kRange);
    ASSERT_TRUE(own) << own.error();
    EXPECT_EQ(own->name, "track 4");
    EXPECT_EQ(own->by, "its pose");
    EXPECT_NEAR(own->poses.lag, 1.5, 0.5);
    EXPECT_NEAR(own->poses.poses[300].x, circle(-2, 0)[300].x, 1e-6);
    EXPECT_NEAR(std::abs(std::remainder(own->poses.poses[300].heading, 2 * std::numbers::pi)), 0, 1e-6);
  }
}

TEST(OwnPath, ContinuesWhereTheTruthGaveItAnotherName) {
  const auto own = own_path(
      truth_with({{"track 3", circle(1, 1)}, {"track 4", circle(-2, 0, 0, 40)}, {"track 9", circle(-2, 0, 42, 60)}}),
      posed(-2, 0, 0, false), kRange);
  ASSERT_TRUE(own) << own.error();
  EXPECT_TRUE(place_at(own->path, 20));
  EXPECT_TRUE(place_at(own->path, 50));
  EXPECT_FALSE(place_at(own->path, 41));
}

TEST(OwnPath, PosesThatFitSeveralRobotsOrNoneDecideNothing) {
  EXPECT_FALSE(
      own_path(truth_with({{"track 3", circle(1, 1)}, {"track 4", circle(1.05, 1)}}), posed(1, 1, 0, false), kRange));
  EXPECT_FALSE(
      own_path(truth_with({{"track 3", circle(3, 3)}, {"track 4", circle(-4, 0)}}), posed(0, 0, 0, false), kRange));
}

TEST(OwnPath, TheOnlyRobotIsOurs) {
  const auto own = own_path(truth_with({{"robot 1", circle(1, 1)}}), {}, kRange);
  ASSERT_TRUE(own);
  EXPECT_EQ(own->by, "the only robot");
}

TEST(OwnPath, ATruthWithoutRobotsIsRefused) {
  const auto refused = own_path({}, posed(1, 1, 0, false), kRange);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), "the truth has no robot");
}

TEST(FitPoses, FramesMayTurnBetweenTheHalves) {
  RobotRecord robot = posed(1, 1, 0, false);
  for (PoseBelief& pose : robot.poses)
    if (pose.at >= 30) pose.x = -pose.x, pose.y = -pose.y;
  const FieldPoses fit = fit_poses(robot.poses, circle(1, 1), kRange);
  EXPECT_LT(fit.error, 0.05);
  EXPECT_NEAR(fit.poses.back().x, circle(1, 1).back().x, 1e-6);
}

TEST(FitPoses, TooFewPlacesAreNoFit) {
  EXPECT_TRUE(fit_poses(posed(1, 1, 0, false).poses, circle(1, 1, 0, 5), kRange).empty());
  EXPECT_TRUE(fit_poses({}, circle(1, 1), kRange).empty());
  EXPECT_TRUE(fit_poses(posed(1, 1, 0, false).poses, {}, kRange).empty());
}

TEST(PoseAt, IsTheNewestOfTheLastTenthOfASecond) {
  const std::vector<PoseBelief> poses{{.at = 1}, {.at = 2}};
  EXPECT_EQ(pose_at(poses, 2.05), &poses[1]);
  EXPECT_EQ(pose_at(poses, 2), &poses[1]);
  EXPECT_EQ(pose_at(poses, 1.5), nullptr);
  EXPECT_EQ(pose_at(poses, 0.9), nullptr);
}

TEST(PlaceAtAPath, IsInterpolatedButNotOverAPause) {
  const Path path{{.at = 0, .x = 0, .y = 0}, {.at = 0.1, .x = 1, .y = 2}, {.at = 1, .x = 3, .y = 3}};
  EXPECT_NEAR(place_at(path, 0.05)->x, 0.5, 1e-12);
  EXPECT_NEAR(place_at(path, 0.05)->y, 1, 1e-12);
  EXPECT_EQ(place_at(path, 1)->x, 3);
  EXPECT_FALSE(place_at(path, 0.5));
  EXPECT_FALSE(place_at(path, -1));
  EXPECT_FALSE(place_at({}, 0));
}

}  // namespace
}  // namespace robot::lab
