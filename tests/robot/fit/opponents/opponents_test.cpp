#include "robot/fit/opponents/opponents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "sim/statistics/walking.h"
#include "tests/support/planted_touches.h"

namespace robot::fit {
namespace {

sim::Models outside_models() {
  sim::Models models{};
  models.ball.deceleration = 0.3f;
  models.motion.walk.forward = 0.35f;
  return models;
}

/// A robot that walks to and fro with a speed, stands after each way, and is seen with an error.
lab::TrueRobotPath hurrying(const std::string& name, double speed, double seconds, double error, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, error);
  lab::TrueRobotPath robot{.name = name, .path = {}};
  double x = 0, ahead = 1;
  for (int i = 0; i < 30 * seconds; ++i) {
    if (i % 300 < 220) x += ahead * speed / 30;
    if (i % 300 == 299) ahead = -ahead;
    robot.path.push_back({.at = i / 30., .x = x + normal(random), .y = 1 + normal(random)});
  }
  return robot;
}

Evidence seen_from_outside(lab::TruthRecord record) {
  Evidence evidence;
  evidence.games.push_back(std::make_shared<const TrueGame>(TrueGame{.name = "game", .record = std::move(record)}));
  return evidence;
}

TEST(WalksIn, SpeedsAreThoseOfTheStatisticsOfGames) {
  lab::TruthRecord truth;
  truth.robots = {hurrying("14/2", 0.3, 166, 0.02, 1), hurrying("5/3", 0.2, 166, 0.02, 2)};
  sim::statistics::Window window;
  for (const lab::TrueRobotPath& path : truth.robots) {
    sim::statistics::Robot robot;
    for (const lab::PlaceAt& place : path.path)
      robot.frames.push_back(
          sim::statistics::Sighting{.position = {static_cast<float>(place.x), static_cast<float>(place.y)}});
    window.robots.push_back(std::move(robot));
  }
  const sim::statistics::Walking walking = walking_of(window);
  const Report report = fit_opponents(seen_from_outside(truth), outside_models());
  ASSERT_TRUE(report.figure("opponents.speed") && report.figure("opponents.speed_median"));
  EXPECT_NEAR(report.figure("opponents.speed")->value, walking.speed_99, 0.003);
  EXPECT_NEAR(report.figure("opponents.speed_median")->value, walking.speed_median, 0.003);
}

TEST(WalksIn, LeavesOutRobotsThatAreKnownAndPlacesThatAreImpossible) {
  lab::TruthRecord truth;
  truth.robots = {hurrying("14/2", 0.3, 60, 0, 1), hurrying("5/3", 0.2, 60, 0, 2)};
  truth.robots[1].path[100].x = NAN;
  const auto walks = walks_in(truth, {"14/2"}, 2);
  ASSERT_EQ(walks.size(), 1u);
  EXPECT_EQ(walks[0].team, "5");
  EXPECT_EQ(walks[0].recording, 2u);
  for (const double speed : walks[0].speeds) EXPECT_LT(speed, 0.21);
}

TEST(TopSpeedOf, ARobotThatNeverHurriesOrHardlyWalksHasNoTopSpeed) {
  SeenWalk walk;
  for (int i = 0; i < 1000; ++i) walk.speeds.push_back(i < 20 ? 0.4 : 0.1);
  EXPECT_FALSE(top_speed_of(walk));
  walk.speeds.assign(300, 0.3);
  EXPECT_FALSE(top_speed_of(walk));
  walk.speeds.assign(1000, 0.3);
  ASSERT_TRUE(top_speed_of(walk));
  EXPECT_NEAR(top_speed_of(walk)->value, 0.3, 0.02);
}

TEST(FitPaces, BothEndsOfThePlantedRangeAreInsideTheirIntervals) {
  int forward = 0, spread = 0;
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    std::vector<TopSpeed> tops;
    for (int k = 0; k < 10; ++k)
      tops.push_back({.value = 0.3 * (1 - 0.4 * std::uniform_real_distribution<double>()(random)), .deviation = 0.003});
    const PaceFit fit = fit_paces(tops);
    forward += fit.forward_low <= 0.3 && 0.3 <= fit.forward_high;
    spread += fit.spread_low <= 0.4 && 0.4 <= fit.spread_high;
  }
  EXPECT_GE(forward, 90);
  EXPECT_GE(spread, 90);
}

TEST(Opponents, FitsTheWalkOfTheModelsOnlyIfNoRobotRecordedAnything) {
  lab::TruthRecord truth;
  for (int i = 0; i < 6; ++i)
    truth.robots.push_back(hurrying("14/" + std::to_string(i + 1), 0.2 + 0.02 * i, 300, 0.02, 1));
  Evidence evidence = seen_from_outside(truth);
  const Report report = fit_opponents(evidence, outside_models());
  ASSERT_TRUE(report.figure("walk.forward") && report.figure("walk.spread"));
  EXPECT_NEAR(report.figure("walk.forward")->value, 0.32, 0.03);
  WatchedRobot watched{
      .name = "own", .session = {}, .game = evidence.games[0], .path = truth.robots[0].path, .clock = {}};
  watched.session.info.robot = "14/1";
  evidence.robots.push_back(std::move(watched));
  const OpponentsSeen others = read_opponents(evidence, 0.3);
  EXPECT_EQ(others.walks.size(), 5u);
  EXPECT_EQ(fit_opponents(others, outside_models()).figure("walk.forward"), nullptr);
}

TEST(Opponents, KicksOfRobotsAndTheirReach) {
  OpponentsSeen seen{.recordings = {"game"}, .walks = {}, .kicks = {}};
  for (int i = 0; i < 41; ++i) {
    const double speed = 0.6 + 0.03 * i;
    seen.kicks.push_back({.recording = 0, .at = 1. * i, .team = "5", .speed = speed, .reach = speed * speed / 0.6});
  }
  const Report report = fit_opponents(seen, outside_models());
  ASSERT_TRUE(report.figure("opponents.kick_speed") && report.figure("opponents.reach"));
  EXPECT_NEAR(report.figure("opponents.kick_speed")->value, 1.2, 1e-9);
  EXPECT_NEAR(report.figure("opponents.reach")->value, 1.68 * 1.68 / 0.6, 1e-9);
  EXPECT_LT(report.figure("opponents.reach")->low, 4.7);
}

TEST(Opponents, AReboundIsNoKick) {
  EXPECT_TRUE(read_opponents(seen_from_outside(tests::planted_touches({.rebounds = 12}, 1)), 0.3).kicks.empty());
}

TEST(Opponents, TooFewObservationsAreKeptWithTheReason) {
  const Report report = fit_opponents(Evidence{}, outside_models());
  EXPECT_TRUE(report.empty());
  ASSERT_EQ(report.kept.size(), 6u);
  EXPECT_EQ(report.kept[0],
            "opponents.speed: expected at least 60 s of robots that walk and recorded nothing, got 0 s");
  EXPECT_EQ(report.kept[2],
            "walk.forward: expected at least 5 robots that walk for a minute, and fast for a quarter of it, got 0");
  EXPECT_EQ(report.kept[4], "opponents.kick_speed: expected at least 15 kicks by robots that recorded nothing, got 0");
}

}  // namespace
}  // namespace robot::fit
