#include "robot/fit/falling/falling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "robot/fit/math/resampling.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

sim::Models falling_models() {
  sim::Models models{};
  models.contact.robot_radius = 0.16f, models.contact.lying_radius = 0.25f;
  models.motion.falls = {
      .per_minute_walking = 0.33f, .per_second_touching = 0.05f, .lying = 1, .getting_up = 2.2f, .failure = 0.1f};
  return models;
}

/// A robot that walks to and fro at 0.2 m/s, 30 images a second.
lab::TrueRobotPath walker(const std::string& name, double seconds, double y) {
  lab::TrueRobotPath robot{.name = name, .path = {}};
  for (int i = 0; i < 30 * seconds; ++i) {
    const double way = std::fmod(0.2 * i / 30., 4.);
    robot.path.push_back({.at = i / 30., .x = way < 2 ? way : 4 - way, .y = y, .fallen = false});
  }
  return robot;
}

void lie_down(lab::TrueRobotPath& robot, double from, double to) {
  for (lab::PlaceAt& place : robot.path)
    if (place.at >= from - 1e-6 && place.at < to - 1e-6) place.fallen = true;
}

lab::TruthRecord truth_of(std::vector<lab::TrueRobotPath> robots) {
  lab::TruthRecord truth;
  truth.robots = std::move(robots);
  return truth;
}

Evidence evidence_of_falls(lab::TruthRecord truth) {
  Evidence evidence;
  evidence.games.push_back(std::make_shared<const TrueGame>(TrueGame{.name = "game", .record = std::move(truth)}));
  return evidence;
}

TEST(FallsIn, EachFallWithItsTimeOnTheGround) {
  auto robot = walker("14/2", 60, 0);
  lie_down(robot, 10, 13.2), lie_down(robot, 30, 32);
  const auto risks = falls_in(truth_of({robot}), {}, 4);
  ASSERT_EQ(risks.size(), 1u);
  EXPECT_EQ(risks[0].recording, 4u);
  EXPECT_EQ(risks[0].robot, "14/2");
  ASSERT_EQ(risks[0].falls.size(), 2u);
  EXPECT_NEAR(risks[0].falls[0].at, 10, 0.02);
  EXPECT_NEAR(risks[0].falls[0].down.value_or(0), 3.2, 0.02);
  EXPECT_NEAR(risks[0].falls[1].down.value_or(0), 2, 0.02);
  EXPECT_TRUE(risks[0].falls[0].walking);
  EXPECT_FALSE(risks[0].falls[0].touching);
  EXPECT_NEAR(risks[0].walking, 60 - 5.2, 1.5);
  EXPECT_EQ(risks[0].touching, 0);
}

TEST(FallsIn, LabelsThatFlickerAreOneFallOrNoFall) {
  auto robot = walker("14/2", 60, 0);
  lie_down(robot, 10, 14);
  for (std::size_t i = 0; i < robot.path.size(); ++i)
    if (i % 8 == 0) robot.path[i].fallen = !*robot.path[i].fallen;
  const auto risks = falls_in(truth_of({robot}), {}, 0);
  ASSERT_EQ(risks[0].falls.size(), 1u);
  EXPECT_NEAR(risks[0].falls[0].down.value_or(0), 4, 0.3);
}

TEST(FallsIn, ARobotThatIsDownWhenItComesIntoViewFellBefore) {
  auto robot = walker("14/2", 20, 0);
  lie_down(robot, 0, 3), lie_down(robot, 18, 20);
  const auto risks = falls_in(truth_of({robot}), {}, 0);
  ASSERT_EQ(risks[0].falls.size(), 1u);
  EXPECT_NEAR(risks[0].falls[0].at, 18, 0.02);
  EXPECT_FALSE(risks[0].falls[0].down) << "its end was not seen";
}

TEST(FallsIn, TheRoomBetweenRobotsSaysWhetherTheyTouch) {
  auto one = walker("14/2", 60, 0);
  lie_down(one, 20, 23);
  const auto touching = falls_in(truth_of({one, walker("5/2", 60, 0.33)}), {}, 0);
  EXPECT_TRUE(touching[0].falls[0].touching);
  EXPECT_NEAR(touching[0].touching, 57, 3);
  EXPECT_EQ(touching[0].overlapping, 0);
  const auto apart = falls_in(truth_of({one, walker("5/2", 60, 0.5)}), {}, 0);
  EXPECT_FALSE(apart[0].falls[0].touching);
  EXPECT_EQ(apart[0].touching, 0);
}

TEST(FallsIn, ATruthThatDoesNotJudgeFallsOrIsDamagedHasNoRobots) {
  auto robot = walker("14/2", 20, 0);
  for (lab::PlaceAt& place : robot.path) place.fallen.reset();
  EXPECT_TRUE(falls_in(truth_of({robot}), {}, 0).empty());
  EXPECT_TRUE(falls_in({}, {}, 0).empty());
  auto damaged = walker("14/2", 60, 0);
  lie_down(damaged, 10, 13);
  for (std::size_t i = 0; i < damaged.path.size(); i += 50) damaged.path[i].x = NAN;
  const auto risks = falls_in(truth_of({damaged}), {}, 0);
  ASSERT_EQ(risks.size(), 1u);
  EXPECT_EQ(risks[0].falls.size(), 1u);
  EXPECT_TRUE(std::isfinite(risks[0].walking));
}

/// Falls of ten robots, each with as much time at risk.
std::vector<FallRisk> random_falls(double per_walking, double per_touching, double walking, double touching,
                                   std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<FallRisk> robots;
  for (int i = 0; i < 10; ++i) {
    FallRisk robot{.recording = 0,
                   .robot = std::to_string(i),
                   .walking = walking,
                   .touching = touching,
                   .overlapping = touching,
                   .upright = walking,
                   .falls = {}};
    const auto add = [&](double expected, bool walks, bool touches) {
      const int falls = std::poisson_distribution<int>(expected)(random);
      for (int k = 0; k < falls; ++k)
        robot.falls.push_back({.at = 1, .walking = walks, .touching = touches, .down = 3});
    };
    // robots that touch walk half of the time
    add(per_walking * (walking - touching / 2), true, false);
    add((per_walking + per_touching) * touching / 2, true, true);
    add(per_touching * touching / 2, false, true);
    robots.push_back(std::move(robot));
  }
  return robots;
}

TEST(FallRates, BothPlantedRatesAreInsideTheirIntervals) {
  int walking = 0, touching = 0;
  double bias = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const FallRates rates = fit_fall_rates(random_falls(0.006, 0.05, 900, 60, seed));
    walking += rates.walking.low <= 0.006 && 0.006 <= rates.walking.high;
    touching += rates.touching.low <= 0.05 && 0.05 <= rates.touching.high;
    bias += (rates.touching.value - 0.05) / 100;
  }
  EXPECT_GE(walking, 91);
  EXPECT_GE(touching, 91);
  EXPECT_NEAR(bias, 0, 0.003);
}

TEST(FallRates, WithoutContactTheRateIsFallsOverTime) {
  std::vector<FallRisk> robots(1);
  robots[0].walking = 1000;
  const FallRates no_falls = fit_fall_rates(robots);
  EXPECT_EQ(no_falls.walking.value, 0);
  EXPECT_EQ(no_falls.walking.low, 0);
  EXPECT_NEAR(no_falls.walking.high, 3.841 / 2 / 1000, 1e-6);
  EXPECT_EQ(no_falls.touching.high, INFINITY) << "no time at risk";
  for (int i = 0; i < 20; ++i) robots[0].falls.push_back({.at = 1, .walking = true});
  const FallRates rates = fit_fall_rates(robots);
  EXPECT_NEAR(rates.walking.value, 0.02, 1e-6);
  EXPECT_NEAR(rates.walking.low, 0.0125, 0.0005);
  EXPECT_NEAR(rates.walking.high, 0.0301, 0.0005);
}

TEST(FallRates, RobotsThatDifferHaveWiderIntervals) {
  auto robots = random_falls(0.006, 0.05, 900, 60, 1);
  const FallRates alike = fit_fall_rates(robots);
  for (FallRisk& robot : robots)
    if (robot.robot != "0") std::ranges::move(robot.falls, std::back_inserter(robots[0].falls)), robot.falls.clear();
  const FallRates one = fit_fall_rates(robots);
  EXPECT_NEAR(one.walking.value, alike.walking.value, 1e-9);
  EXPECT_GT(one.walking.high - one.walking.low, 2 * (alike.walking.high - alike.walking.low));
}

TEST(FallRates, FallsWithoutACauseAreSharedLikeTheOthers) {
  auto robots = random_falls(0.006, 0.05, 900, 60, 1);
  const FallRates before = fit_fall_rates(robots);
  for (std::size_t i = 0; i < before.falls / 10; ++i) robots[i % 10].falls.push_back({.at = 1});
  const FallRates after = fit_fall_rates(robots);
  EXPECT_EQ(after.unexplained, before.falls / 10);
  EXPECT_NEAR(after.walking.value / before.walking.value,
              static_cast<double>(after.falls) / static_cast<double>(before.falls), 1e-3);
}

TEST(FallRates, RobotsThatTouchOverlapHalfOfTheTime) {
  auto robots = random_falls(0.006, 0.05, 900, 60, 1);
  for (FallRisk& robot : robots) robot.overlapping = robot.touching * 0.4;
  EXPECT_NEAR(fit_fall_rates(robots).contact, 2 * 0.977 * 0.4, 1e-9);
}

TEST(GroundTime, OneAttemptAndTheirFailures) {
  std::mt19937_64 random(3);
  std::vector<double> times;
  for (int i = 0; i < 200; ++i) {
    double time = 0;
    do time += 3 + 0.15 * std::normal_distribution<double>()(random);
    while (random() % 100 < 20);
    times.push_back(time);
  }
  const GroundTime model = fit_ground_time(times, all_of(times.size()));
  EXPECT_NEAR(model.attempt, 3, 0.05);
  EXPECT_NEAR(model.failure, 0.2, 0.06);
  EXPECT_NEAR(model.deviation, 0.15, 0.04);
}

TEST(Falling, TooLittleTimeAndTooFewFallsAreKeptWithTheReason) {
  const Report report = fit_falling(evidence_of_falls(truth_of({walker("14/2", 60, 0)})), falling_models());
  EXPECT_TRUE(report.empty());
  ASSERT_EQ(report.kept.size(), 5u);
  EXPECT_EQ(report.kept[0], "falls.per_minute_walking: expected at least 10 minutes of robots that walk, got 1.0");
  EXPECT_EQ(report.kept[1], "falls.per_second_touching: expected at least 60 s of robots in contact, got 0.0 s");
  EXPECT_EQ(report.kept[2],
            "falls.lying: the truth shows only the time on the ground, and no robot recorded its motion status");
  EXPECT_EQ(report.kept[4], "falls.failure: expected at least 10 complete times on the ground, got 0");
  EXPECT_EQ(fit_falling(Evidence{}, falling_models()).kept[0],
            "falls.per_minute_walking: expected a truth that judges falls, got no such recording");
}

TEST(Falling, TheTimesOfTheTruthGiveOneAttempt) {
  auto robot = walker("14/2", 900, 0);
  for (int i = 0; i < 30; ++i) lie_down(robot, 20 + 25 * i, 20 + 25 * i + (i % 5 == 0 ? 6.2 : 3.1));
  const Report report = fit_falling(evidence_of_falls(truth_of({robot})), falling_models());
  const Figure *down = report.figure("falls.down"), *failure = report.figure("falls.failure");
  ASSERT_TRUE(down && failure);
  EXPECT_TRUE(down->low <= 3.1 && 3.1 <= down->high) << down->value;
  EXPECT_TRUE(failure->low <= 1 / 6. && 1 / 6. <= failure->high) << failure->value;
  EXPECT_EQ(failure->events, 36u);
  EXPECT_EQ(report.pictures.size(), 2u);
  EXPECT_EQ(report.tables.at(0).second.rows.size(), 30u);
}

TEST(Falling, TimesThatScatterDoNotTellAttemptsApart) {
  FallsSeen seen{
      .recordings = {"game"}, .robots = {{.recording = 0, .robot = "14/2"}}, .phases = {}, .phase_recordings = {}};
  for (int i = 0; i < 30; ++i) seen.robots[0].falls.push_back({.at = 1, .walking = true, .down = 1 + 0.2 * i});
  const Report report = fit_falling(seen, falling_models());
  EXPECT_EQ(report.figure("falls.failure"), nullptr);
  EXPECT_NE(report.kept.back().find("cannot be told apart"), std::string::npos);
}

TEST(Falling, RecordedPhasesGiveBothDurationsAndTheFailures) {
  FallsSeen seen{.recordings = {}, .robots = {}, .phases = {.interval = 1 / 30.}, .phase_recordings = {"14/2"}};
  std::mt19937_64 random(1);
  for (int i = 0; i < 40; ++i) {
    seen.phases.lying.push_back(1.2 + 0.1 * std::normal_distribution<double>()(random));
    seen.phases.getting_up.push_back(i == 7 ? 20 : 2.5);
  }
  seen.phases.attempts = 40, seen.phases.failures = 8;
  const Report report = fit_falling(seen, falling_models());
  const Figure *lying = report.figure("falls.lying"), *rising = report.figure("falls.getting_up");
  ASSERT_TRUE(lying && rising && report.figure("falls.failure"));
  EXPECT_TRUE(lying->low < 1.2 && 1.2 < lying->high);
  EXPECT_NEAR(rising->value, 2.5, 0.02) << "a single robot that was picked up hardly counts";
  EXPECT_EQ(report.figure("falls.failure")->value, 0.2);
  EXPECT_EQ(report.figure("falls.down"), nullptr);
}

TEST(Falling, TheMotionStatusOfSimulatedRobotsHasThePhases) {
  const ::tests::TemporaryFolder folder;
  const Evidence evidence = tests::simulated_robots(
      folder.path() / "game",
      {.models = "match,falls.per_minute_walking=20,falls.lying=1.5,falls.getting_up=2,falls.failure=0.3",
       .seconds = 90,
       .place_error = 0.02});
  const Report report = fit_falling(evidence, falling_models());
  const Figure *lying = report.figure("falls.lying"), *rising = report.figure("falls.getting_up");
  ASSERT_TRUE(lying && rising && report.figure("falls.failure")) << to_text(report);
  EXPECT_TRUE(lying->low <= 1.5 && 1.5 <= lying->high) << lying->value;
  EXPECT_TRUE(rising->low <= 2 && 2 <= rising->high) << rising->value;
  EXPECT_TRUE(report.figure("falls.failure")->low <= 0.3 && 0.3 <= report.figure("falls.failure")->high);
}

}  // namespace
}  // namespace robot::fit
