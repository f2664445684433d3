#include "robot/fit/localisation/odometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "robot/fit/localisation/odometry_fit.h"
#include "tests/support/planted_poses.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

using tests::PlantedPoses;

Drift drift_of(const std::vector<WatchedMotion>& motions) {
  Drift drift;
  for (const WatchedMotion& motion : motions) add_drift(motion, drift);
  return drift;
}

PlantedPoses walks_of(double minutes) {
  PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = minutes;
  return planted;
}

double value_of(const Report& report, const std::string& name) {
  const auto figure = std::ranges::find(report.figures, name, &Figure::name);
  return figure == report.figures.end() ? NAN : figure->value;
}

TEST(Odometry, IntervalsCoverThePlantedValuesDespiteTheTruthsErrors) {
  const PlantedPoses planted = walks_of(4);
  const auto& model = planted.models.perception.localisation;
  const std::map<std::string, double> values{{"localisation.translation_noise", model.translation_noise},
                                             {"localisation.rotation_noise", model.rotation_noise},
                                             {"localisation.rotation_per_metre", model.rotation_per_metre},
                                             {"localisation.bias", model.bias}};
  int covered = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Report report = odometry_report(drift_of(tests::planted_poses(planted, 5, seed)), planted.models);
    ASSERT_EQ(report.figures.size(), 4u);
    for (const Figure& figure : report.figures)
      covered += figure.low <= values.at(figure.name) && values.at(figure.name) <= figure.high;
  }
  EXPECT_GE(covered, 13);
}

TEST(Odometry, ErrorsOfTheTruthBiasNothing) {
  PlantedPoses planted = walks_of(6);
  const auto exact = fit_drift(drift_of(tests::planted_poses(planted, 4, 7)).windows, 4).model;
  planted.truth_error = 0.04, planted.heading_error = 0.1, planted.late = 0.02;
  const auto wrong = fit_drift(drift_of(tests::planted_poses(planted, 4, 7)).windows, 4).model;
  EXPECT_NEAR(wrong.translation_noise, exact.translation_noise, 0.006);
  EXPECT_NEAR(wrong.rotation_noise, exact.rotation_noise, 0.012);
  EXPECT_GT(wrong.place_error, exact.place_error);
  EXPECT_GT(wrong.heading_error, exact.heading_error);
}

TEST(Odometry, ScalesOfEachRecordingAreFound) {
  PlantedPoses planted = walks_of(10);
  planted.models.perception.localisation.bias = 0.2f;
  const auto fit = fit_drift(drift_of(tests::planted_poses(planted, 6, 2)).windows, 6);
  EXPECT_EQ(known_scales(fit), 12u);
  const RootInterval bias = bias_interval(fit);
  EXPECT_LE(bias.low, 0.2);
  EXPECT_GE(bias.high, 0.2);
  // odometry without errors has no bias
  planted.models.perception.localisation.bias = 0;
  const auto exact = fit_drift(drift_of(tests::planted_poses(planted, 6, 2)).windows, 6);
  EXPECT_LT(bias_interval(exact).low, 0.005);
}

WatchedMotion mirrored(WatchedMotion motion) {
  for (OdometryAt& one : motion.odometry) one.y = -one.y, one.heading = -one.heading;
  for (TrueMoment& one : motion.truth) one.y = -one.y, one.heading = -one.heading;
  return motion;
}

TEST(Odometry, AMirroredFieldGivesTheSame) {
  const auto walks = tests::planted_poses(walks_of(3), 3, 5);
  std::vector<WatchedMotion> other;
  for (const WatchedMotion& walk : walks) other.push_back(mirrored(walk));
  const auto one = fit_drift(drift_of(walks).windows, 3).model, two = fit_drift(drift_of(other).windows, 3).model;
  EXPECT_NEAR(one.translation_noise, two.translation_noise, 1e-6);
  EXPECT_NEAR(one.rotation_noise, two.rotation_noise, 1e-6);
  EXPECT_NEAR(one.rotation_per_metre, two.rotation_per_metre, 1e-6);
}

TEST(Odometry, TheOrderOfRecordingsDoesNotMatter) {
  auto walks = tests::planted_poses(walks_of(3), 3, 6);
  const auto one = fit_drift(drift_of(walks).windows, 3).model;
  std::ranges::reverse(walks);
  const auto two = fit_drift(drift_of(walks).windows, 3).model;
  EXPECT_NEAR(one.translation_noise, two.translation_noise, 1e-6);
  EXPECT_NEAR(one.rotation_noise, two.rotation_noise, 1e-6);
}

TEST(Odometry, SingleBadWindowsAndNumbersHardlyCount) {
  Drift drift = drift_of(tests::planted_poses(walks_of(5), 3, 8));
  const auto before = fit_drift(drift.windows, 3).model;
  for (std::size_t i = 5; i < drift.windows.size(); i += 60) drift.windows[i].error_x += 3;
  drift.windows[10].error_x = drift.windows[20].error_turn = NAN;
  drift.windows[30].grown_way = INFINITY;
  const auto after = fit_drift(drift.windows, 3).model;
  EXPECT_NEAR(after.translation_noise, before.translation_noise, 0.05 * before.translation_noise);
  EXPECT_NEAR(after.rotation_noise, before.rotation_noise, 0.05 * before.rotation_noise);
  EXPECT_EQ(odometry_report(drift, tests::match_models()).figures.size(), 4u);
}

TEST(Odometry, WithoutStatusTheWayIsThatOfTheTruth) {
  auto walks = tests::planted_poses(walks_of(6), 4, 9);
  const auto one = fit_drift(drift_of(walks).windows, 4).model;
  for (WatchedMotion& walk : walks) walk.status.clear();
  const auto two = fit_drift(drift_of(walks).windows, 4).model;
  EXPECT_NEAR(two.translation_noise, one.translation_noise, 0.15 * one.translation_noise);
}

TEST(Odometry, AWindowEndsWhereTheRobotIsNotOnItsOwnFeet) {
  WatchedMotion walk = tests::planted_pose_walk(walks_of(2), 4);
  const auto free_of = [](const Drift& drift, double from, double to) {
    return std::ranges::all_of(drift.windows, [&](const DriftWindow& window) {
      return window.at + window.duration <= from + 0.05 || window.at >= to - 0.05;
    });
  };
  const auto between = [](double at) { return at > 40 && at < 50; };
  WatchedMotion lies = walk, crowd = walk, carried = walk, penalised = walk, gap = walk, jump = walk;
  for (TrueMoment& one : lies.truth) one.fallen = between(one.at);
  for (TrueMoment& one : crowd.truth) one.crowded = between(one.at);
  for (GameAt& one : carried.games) one.moves = !between(one.at);
  for (GameAt& one : penalised.games) one.penalised = between(one.at);
  std::erase_if(gap.odometry, [&](const OdometryAt& one) { return between(one.at); });
  for (const WatchedMotion& motion : {lies, crowd, gap}) EXPECT_TRUE(free_of(drift_of({motion}), 40, 50));
  // the state of the game comes twice a second
  for (const WatchedMotion& motion : {carried, penalised}) EXPECT_TRUE(free_of(drift_of({motion}), 40.6, 50));
  EXPECT_GT(drift_of({lies}).losses.lying, 250u);
  EXPECT_GT(drift_of({crowd}).losses.crowded, 250u);
  EXPECT_GT(drift_of({carried}).losses.carried, 250u);
  for (TrueMoment& one : jump.truth) one.x += one.at > 45 ? 2 : 0;
  EXPECT_TRUE(free_of(drift_of({jump}), 44.95, 45.05));
}

TEST(Odometry, TooFewWalksAreRefused) {
  const sim::Models models = tests::match_models();
  EXPECT_EQ(fit_odometry({}, models).kept.at(0),
            "localisation.bias and its noises: expected a robot beside the truth, got 0");
  const Report report = odometry_report(drift_of({tests::planted_pose_walk(walks_of(0.3), 1)}), models);
  EXPECT_TRUE(report.empty());
  EXPECT_EQ(report.kept.at(0),
            "localisation.translation_noise, rotation_noise, rotation_per_metre and bias: expected at least 40 "
            "windows of a walk that nobody disturbs, got 4");
  EXPECT_EQ(report.needs.size(), 1u);
}

TEST(Odometry, TwoRobotsShowNoBias) {
  const Report report = odometry_report(drift_of(tests::planted_poses(walks_of(5), 2, 1)), tests::match_models());
  EXPECT_EQ(report.figures.size(), 3u);
  EXPECT_EQ(report.kept.at(0),
            "localisation.bias: expected at least 6 known scales, two of each robot and game, got 4");
}

TEST(Odometry, ARobotWithoutErrorsHasAlmostNoNoise) {
  PlantedPoses planted = walks_of(4);
  auto& model = planted.models.perception.localisation;
  model.translation_noise = model.rotation_noise = model.rotation_per_metre = 0;
  const auto fit = fit_drift(drift_of(tests::planted_poses(planted, 3, 3)).windows, 3).model;
  EXPECT_LT(fit.translation_noise, 0.012);
  EXPECT_LT(fit.rotation_noise, 0.03);
}

TEST(Odometry, ASimulatedGameIsEvidence) {
  const ::tests::TemporaryFolder folder;
  const Evidence evidence = tests::simulated_robots(
      folder.path() / "game", {.seconds = 25, .place_error = 0.02, .heading_error = 0.05, .clock_error = 0.01});
  const Report report = fit_odometry(evidence, tests::match_models());
  EXPECT_NEAR(value_of(report, "localisation.translation_noise"), 0.1, 0.03);
  EXPECT_EQ(report.pictures.size(), 3u);
  EXPECT_GE(report.results.size(), 1u);
  EXPECT_EQ(report.tables.at(0).first, "odometry");
  EXPECT_EQ(report.title, "How the robots' odometry drifts");

  Evidence headless = evidence;
  for (WatchedRobot& robot : headless.robots)
    for (lab::PlaceAt& place : robot.path) place.heading = NAN;
  EXPECT_EQ(fit_odometry(headless, tests::match_models()).kept.at(0),
            "localisation.bias and its noises: expected the robots' headings in the truth, got 0");
  Evidence silent = evidence;
  for (WatchedRobot& robot : silent.robots)
    std::erase_if(robot.session.streams,
                  [](const logging::StreamFile& stream) { return stream.topic.ends_with("/odometry"); });
  EXPECT_EQ(fit_odometry(silent, tests::match_models()).kept.at(0),
            "localisation.bias and its noises: expected a recording with odometry, got 0");
}

}  // namespace
}  // namespace robot::fit
