#include "robot/fit/walking/walking.h"

#include <gtest/gtest.h>

#include <set>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "robot/fit/walking/paces.h"
#include "tests/support/planted_walks.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::tests {
namespace {

using fit::Figure, fit::Report;

/// Models whose walk is another one than the planted one.
sim::Models other_models(bool spread) {
  sim::Models models = walking_models();
  models.effects.walk_spread = spread;
  models.motion.walk = {.forward = 0.35f,
                        .backward = 0.27f,
                        .sideward = 0.24f,
                        .turn_rate = 1.222f,
                        .acceleration = 0.6f,
                        .turn_acceleration = 4,
                        .turn_cost = 0.73f,
                        .slow_down = 0.1f,
                        .step_duration = 0.25f,
                        .spread = 0.5f,
                        .speed_noise = 0.15f,
                        .turn_noise = 0.1f,
                        .start_delay = 0.25f,
                        .stop_delay = 0.5f};
  return models;
}

Report report_of(const PlantedWalks& planted, std::uint64_t seed) {
  return fit::fit_walking(drives_of(walked_drills(planted, seed), planted.clock_deviation),
                          other_models(planted.models.effects.walk_spread));
}

std::map<std::string, double> planted_values(const sim::motion::Walk& walk) {
  return {{"walk.forward", walk.forward},         {"walk.backward", walk.backward},
          {"walk.sideward", walk.sideward},       {"walk.turn_rate", walk.turn_rate},
          {"walk.turn_cost", walk.turn_cost},     {"walk.acceleration", walk.acceleration},
          {"walk.start_delay", walk.start_delay}, {"walk.turn_acceleration", walk.turn_acceleration},
          {"walk.stop_delay", walk.stop_delay},   {"walk.speed_noise", walk.speed_noise},
          {"walk.turn_noise", walk.turn_noise}};
}

bool keeps(const Report& report, const std::string& sentence) {
  return std::ranges::any_of(report.kept,
                             [&](const std::string& kept) { return kept.find(sentence) != std::string::npos; });
}

TEST(Walking, FindsThePlantedWalkWithinItsIntervals) {
  std::size_t figures = 0, covered = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const PlantedWalks planted{.seconds = 600};
    const Report report = report_of(planted, seed);
    for (const auto& [name, value] : planted_values(planted.models.motion.walk)) {
      const Figure* figure = report.figure(name);
      ASSERT_TRUE(figure) << name;
      ++figures, covered += value >= figure->low && value <= figure->high ? 1 : 0;
      EXPECT_NEAR(figure->value, value, figure->high - figure->low) << name << " seed " << seed;
    }
  }
  // of 33 figures one or two miss by chance; the bench measures the coverage
  EXPECT_GE(static_cast<double>(covered), 0.85 * static_cast<double>(figures));
}

TEST(Walking, PredictsBetterThanTheDefaultModelsOnDrivesHeldOut) {
  const Report report = report_of({.seconds = 300}, 4);
  ASSERT_EQ(report.scores.size(), 3u);
  EXPECT_LT(report.scores[0].second, report.scores[1].second);
  EXPECT_LT(report.scores[1].second, report.scores[2].second);
}

TEST(Walking, SeveralRobotsShowTheFastestAndTheSpread) {
  PlantedWalks planted{.robots = 8, .seconds = 150};
  planted.models.effects.walk_spread = true;
  const Report report = report_of(planted, 5);
  const Figure *forward = report.figure("walk.forward"), *spread = report.figure("walk.spread");
  ASSERT_TRUE(forward && spread);
  EXPECT_TRUE(forward->low <= 0.3 && 0.3 <= forward->high);
  EXPECT_TRUE(spread->low <= 0.4 && 0.4 <= spread->high);
}

TEST(Walking, TheOrderOfRobotsDoesNotMatter) {
  PlantedWalks planted{.robots = 4, .seconds = 150};
  planted.models.effects.walk_spread = true;
  auto drills = walked_drills(planted, 6);
  const Report one = fit::fit_walking(drives_of(drills, 0), other_models(true));
  std::ranges::reverse(drills);
  const Report other = fit::fit_walking(drives_of(drills, 0), other_models(true));
  ASSERT_EQ(one.figures.size(), other.figures.size());
  for (std::size_t i = 0; i < one.figures.size(); ++i)
    EXPECT_NEAR(one.figures[i].value, other.figures[i].value, 0.1 * (one.figures[i].high - one.figures[i].low));
}

TEST(Walking, AMirroredFieldGivesTheSame) {
  const Report one = report_of({.seconds = 240}, 7), other = report_of({.seconds = 240, .mirrored = true}, 7);
  ASSERT_EQ(one.figures.size(), other.figures.size());
  for (std::size_t i = 0; i < one.figures.size(); ++i)
    EXPECT_NEAR(one.figures[i].value, other.figures[i].value, 0.1 * (one.figures[i].high - one.figures[i].low));
}

TEST(Walking, KeepsWhatTheRecordingsDoNotShow) {
  const Report report = report_of({.seconds = 240, .ahead_only = true}, 8);
  EXPECT_TRUE(report.figure("walk.forward"));
  EXPECT_FALSE(report.figure("walk.sideward"));
  EXPECT_TRUE(
      keeps(report, "walk.backward: expected at least 10 seconds of walking back at full speed in 3 drives, got 0.0"));
  EXPECT_TRUE(keeps(report, "walk.sideward: expected"));
  EXPECT_TRUE(keeps(report, "walk.turn_rate: expected"));
  EXPECT_TRUE(keeps(report, "walk.spread: expected the pace of at least 4 robots, got 1"));
}

TEST(Walking, SaysWhatIsMissing) {
  EXPECT_TRUE(keeps(fit::fit_walking(fit::Drives{}, other_models(false)), "walk: expected at least 3 drives"));
  fit::Drives silent;
  silent.without_command = 2;
  EXPECT_TRUE(keeps(fit::fit_walking(silent, other_models(false)),
                    "expected the topic motion_command, got none from 2 robots"));
  fit::Drives blind;
  blind.without_heading = 1;
  EXPECT_TRUE(keeps(fit::fit_walking(blind, other_models(false)), "expected true headings of robots"));
  EXPECT_FALSE(fit::fit_walking(blind, other_models(false)).needs.empty());
}

TEST(Walking, TheErrorOfTheClockWidensTheStartDelay) {
  const Report exact = report_of({.seconds = 300}, 9), loose = report_of({.seconds = 300, .clock_deviation = 0.05}, 9);
  const Figure *one = exact.figure("walk.start_delay"), *other = loose.figure("walk.start_delay");
  ASSERT_TRUE(one && other);
  EXPECT_GT(other->high - other->low, one->high - one->low);
}

TEST(Walking, APathWithoutHeadingsOrWithOutliersDoesNotSpread) {
  const PlantedWalks planted{.seconds = 300};
  auto drills = walked_drills(planted, 10);
  for (std::size_t i = 100; i < drills[0].path.size(); i += 450) drills[0].path[i].heading = NAN;
  for (std::size_t i = 300; i < drills[0].path.size(); i += 450) drills[0].path[i].x += 0.25;
  const Report report = fit::fit_walking(drives_of(drills, 0), other_models(false));
  ASSERT_TRUE(report.figure("walk.forward"));
  for (const Figure& figure : report.figures)
    EXPECT_TRUE(std::isfinite(figure.value + figure.low + figure.high)) << figure.name;
  EXPECT_NEAR(report.figure("walk.forward")->value, 0.3, 0.02);
}

TEST(Paces, OneRobotIsSlowerThanTheFastestByTheKnownSpread) {
  const fit::Fastest fastest = fit::fastest_of({0}, {0.001}, 0.5);
  EXPECT_NEAR(fastest.log_pace.low, -std::log(1 - 0.5 * 0.025), 0.02);
  EXPECT_NEAR(fastest.log_pace.high, -std::log(0.5), 0.03);
}

TEST(Paces, EqualRobotsMayHaveNoSpread) {
  const fit::Fastest fastest = fit::fastest_of({0, 0.002, -0.003, 0.001, -0.001}, {0.01, 0.01, 0.01, 0.01, 0.01}, {});
  EXPECT_EQ(fastest.spread.low, 0);
  EXPECT_LT(fastest.spread.high, 0.15);
}

TEST(ReadDrives, RobotsOfOneRecordingShareItsClock) {
  const ::tests::TemporaryFolder folder;
  auto evidence = simulated_robots(folder.path() / "game", {.seconds = 60, .clock_error = 0.01});
  append(evidence, simulated_robots(folder.path() / "other", {.seconds = 60, .seed = 2, .clock_error = 0.01}));
  const fit::Drives drives = fit::read_drives(evidence);
  ASSERT_EQ(drives.clocks.size(), drives.robots.size());
  EXPECT_EQ(std::set<std::size_t>(drives.clocks.begin(), drives.clocks.end()).size(), 2u) << "two games";
  for (fit::WatchedRobot& robot : evidence.robots) robot.clock_by = "data";
  const fit::Drives apart = fit::read_drives(evidence);
  for (std::size_t i = 0; i < apart.clocks.size(); ++i) EXPECT_EQ(apart.clocks[i], i) << "recordings of their own";
}

TEST(ReadDrives, AnErrorOfTheTruthDoesNotMakeARobotItsOwnNeighbour) {
  const auto seconds = [](double place_error) {
    const ::tests::TemporaryFolder folder;
    const fit::Drives drives =
        fit::read_drives(simulated_robots(folder.path() / "game", {.seconds = 60, .place_error = place_error}));
    double sum = 0;
    for (const fit::Drive& drive : drives.drives) sum += (drive.poses.back().tick - drive.poses.front().tick) / 30;
    return sum;
  };
  const double exact = seconds(0);
  EXPECT_GT(exact, 60);
  EXPECT_GT(seconds(0.02), 0.8 * exact);
}

}  // namespace
}  // namespace robot::tests
