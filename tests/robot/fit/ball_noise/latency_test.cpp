#include "robot/fit/ball_noise/latency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/planted_sights.h"

namespace robot::fit {
namespace {

using tests::planted_sights, tests::PlantedSights, tests::SightsOfGames;

sim::Models models_for_latency() {
  sim::Models models{};
  models.ball.radius = 0.05F, models.ball.deceleration = 0.3F;
  models.perception.camera.height = 0.45F, models.perception.camera.pixel_angle = 0.00154F;
  models.perception.camera.latency = 0.07F;
  models.perception.noise = {.pixels = 2, .tilt = 0.02F, .tilt_walking = 0.03F, .roll = 0.02F};
  models.perception.ball.far_range = 6;
  return models;
}

Report latency_of(const SightsOfGames& games) { return fit_latency(beside_truth(games.seen), models_for_latency()); }

bool has_note(const Report& report, const std::string& part) {
  return std::ranges::any_of(report.notes,
                             [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(Latency, TheIntervalCoversThePlantedLagDespiteTheErrorsOfTruthAndClock) {
  int covered = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const PlantedSights planted{.lag = static_cast<double>(seed % 4) / 30, .late = 0.01, .episodes = 10};
    const Report report = latency_of(planted_sights(planted, seed));
    const Figure* figure = report.figure("camera.latency");
    ASSERT_TRUE(figure) << seed;
    covered += figure->low <= planted.lag && planted.lag <= figure->high;
    EXPECT_LT(figure->high - figure->low, 0.06);
    EXPECT_GT(figure->high - figure->low, 0.015) << "three clocks, each known to 10 ms";
  }
  EXPECT_GE(covered, 5) << "of 6";
}

TEST(Latency, OfOneRecordingWithItsTruthHasNoErrorOfAClock) {
  const Report report = latency_of(planted_sights({}, 7));
  const Figure* figure = report.figure("camera.latency");
  ASSERT_TRUE(figure);
  EXPECT_NEAR(figure->value, 2 / 30., 0.004);
  EXPECT_LT(figure->high - figure->low, 0.01);
  EXPECT_TRUE(figure->is_known());
}

TEST(Latency, OfTheBeliefIsReported) {
  const Report report = latency_of(planted_sights({}, 8));
  ASSERT_TRUE(report.figure("latency.belief"));
  EXPECT_NEAR(report.figure("latency.belief")->value, 2 / 30. + 0.05, 0.006);
}

TEST(Latency, TheTimeUntilTheWritingAdds) {
  SightsOfGames games = planted_sights({.lag = 1 / 30.}, 9);
  for (SeenBalls& seen : games.seen) seen.writing = 0.04;
  const Report report = latency_of(games);
  ASSERT_TRUE(report.figure("camera.latency") && report.figure("latency.publish"));
  EXPECT_NEAR(report.figure("latency.publish")->value, 0.04, 1e-9);
  EXPECT_NEAR(report.figure("camera.latency")->value, report.figure("latency.percept")->value + 0.04, 1e-9);
  EXPECT_FALSE(has_note(report, "until the writing is not known"));
  EXPECT_TRUE(has_note(latency_of(planted_sights({.episodes = 8}, 9)), "until the writing is not known"));
}

TEST(Latency, AValueBeyondTheModelIsReportedAndKeptOut) {
  const Report report = latency_of(planted_sights({.lag = 0.2}, 10));
  EXPECT_FALSE(report.figure("camera.latency"));
  ASSERT_TRUE(report.figure("latency.total"));
  EXPECT_NEAR(report.figure("latency.total")->value, 0.2, 0.01);
  ASSERT_EQ(report.kept.size(), 1u);
  EXPECT_EQ(report.kept[0].find("camera.latency: expected 0 to 0.1 s, got 0."), 0u) << report.kept[0];
}

TEST(Latency, AValueThatIsOnlyByChanceOutsideIsOnTheBorder) {
  const Report report = latency_of(planted_sights({.lag = 0}, 11));
  const Figure* figure = report.figure("camera.latency");
  ASSERT_TRUE(figure);
  EXPECT_GE(figure->value, 0);
  EXPECT_LE(figure->low, figure->value);
  EXPECT_LE(figure->value, figure->high);
}

TEST(Latency, AClockThatWasComparedByTheBallHidesTheLag) {
  SightsOfGames games = planted_sights({.episodes = 8}, 12);
  for (auto& robot : games.robots) robot->clock_by = "the ball, as 14/2 of the truth (by its number)";
  const Report report = latency_of(games);
  EXPECT_FALSE(report.figure("camera.latency"));
  ASSERT_EQ(report.kept.size(), 1u);
  EXPECT_EQ(report.kept[0],
            "camera.latency: expected clocks that were compared by samples, got clocks that were compared by the ball, "
            "which hides the lag");
}

TEST(Latency, WithoutHeadingsTheDistancesShowIt) {
  const Report report = latency_of(planted_sights({.nearest = 1, .farthest = 2.5, .has_heading = false}, 13));
  const Figure* figure = report.figure("camera.latency");
  ASSERT_TRUE(figure);
  EXPECT_LE(figure->low, 2 / 30.);
  EXPECT_GE(figure->high, 2 / 30.);
}

TEST(Latency, TheOrderOfTheRecordingsDoesNotMatter) {
  SightsOfGames games = planted_sights({.episodes = 10}, 14);
  const Report one = latency_of(games);
  std::ranges::reverse(games.seen);
  const Report other = latency_of(games);
  ASSERT_TRUE(one.figure("camera.latency") && other.figure("camera.latency"));
  EXPECT_NEAR(one.figure("camera.latency")->value, other.figure("camera.latency")->value, 1e-9);
}

TEST(Latency, TooFewRollingBallsAreRefused) {
  const Report few = latency_of(planted_sights({.recordings = 1, .episodes = 2}, 15));
  EXPECT_FALSE(few.figure("camera.latency"));
  ASSERT_EQ(few.kept.size(), 1u);
  EXPECT_NE(few.kept[0].find("camera.latency: expected at least 8 passes of balls that roll at 0.4 m/s or more, got "),
            std::string::npos);
  ASSERT_EQ(few.needs.size(), 1u);
  const Report nothing = fit_latency(Evidence{}, models_for_latency());
  EXPECT_TRUE(nothing.empty());
  EXPECT_EQ(nothing.kept[0], "camera.latency: expected percepts of the ball, got no image with a true place");
}

TEST(Latency, DrawsTheErrorsWithTheFittedLine) {
  const Report report = latency_of(planted_sights({}, 16));
  ASSERT_EQ(report.pictures.size(), 1u);
  const auto& marks = report.pictures[0].marks;
  const auto fitted = std::ranges::find(marks, Mark::Role::fitted, &Mark::role);
  ASSERT_NE(fitted, marks.end());
  EXPECT_LT(fitted->y.back(), 0) << "a late ball is seen behind its place";
  for (const Results& results : report.results)
    for (const auto& row : results.rows) EXPECT_EQ(row.size(), results.head.size());
}

}  // namespace
}  // namespace robot::fit
