#include "robot/fit/ball_noise/ball_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/planted_sights.h"

namespace robot::fit {
namespace {

using tests::planted_sights, tests::PlantedSights, tests::SightsOfGames;

sim::Models usual_models() {
  sim::Models models{};
  models.ball.radius = 0.05F, models.ball.deceleration = 0.3F;
  models.perception.camera.height = 0.45F, models.perception.camera.pixel_angle = 0.00154F;
  models.perception.camera.latency = 0.07F;
  models.perception.noise = {.pixels = 2, .tilt = 0.02F, .tilt_walking = 0.03F, .roll = 0.02F};
  models.perception.ball.far_range = 6;
  return models;
}

Report noise_of(const PlantedSights& planted, std::uint64_t seed) {
  return fit_ball_noise(beside_truth(planted_sights(planted, seed).seen), usual_models());
}

TEST(BallNoise, TheIntervalsCoverThePlantedNoiseDespiteTheErrorsOfTruthAndClock) {
  const PlantedSights planted{.late = 0.01};
  int covered = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const Report report = noise_of(planted, seed);
    const std::pair<const char*, double> values[] = {
        {"noise.tilt", planted.tilt}, {"noise.tilt_walking", planted.tilt_walking}, {"noise.roll", planted.roll}};
    for (const auto& [name, value] : values) {
      const Figure* figure = report.figure(name);
      ASSERT_TRUE(figure) << name;
      covered += figure->low <= value && value <= figure->high;
      EXPECT_NEAR(figure->value, value, 0.1 * value) << name;
      EXPECT_TRUE(figure->is_known()) << name;
      EXPECT_GT(figure->domain.to, figure->domain.from);
    }
  }
  EXPECT_GE(covered, 13) << "of 15";
}

TEST(BallNoise, AClockThatIsHardlyKnownWidensTheInterval) {
  const auto width = [](double late) {
    PlantedSights planted{.late = late};
    const Figure* roll = noise_of(planted, 5).figure("noise.roll");
    return roll ? roll->high - roll->low : 0;
  };
  EXPECT_GT(width(0), 0);
  EXPECT_GT(width(0.05), width(0));
}

TEST(BallNoise, AnExactTruthGivesTheSameNoise) {
  const Report report = noise_of({.truth_error = 0, .heading_error = 0}, 6);
  ASSERT_TRUE(report.figure("noise.tilt"));
  EXPECT_NEAR(report.figure("noise.tilt")->value, 0.015, 0.001);
  EXPECT_NEAR(report.figure("noise.roll")->value, 0.018, 0.001);
}

TEST(BallNoise, ABiasOfARecordingIsReportedAndNoPartOfTheNoise) {
  const Report report = noise_of({.elevation_bias = 0.02, .bearing_bias = 0.1}, 7);
  const Figure* roll = report.figure("noise.roll");
  const Figure* bearing = report.figure("ball_noise.bearing_bias");
  const Figure* range = report.figure("ball_noise.range_bias");
  ASSERT_TRUE(roll && bearing && range);
  EXPECT_NEAR(roll->value, 0.018, 0.0015);
  EXPECT_NEAR(bearing->value, 0.1, 0.005);
  EXPECT_LT(range->value, -0.03) << "it looks lower, so nearer";
}

TEST(BallNoise, FalseBallsHardlyCount) {
  const Report report = noise_of({.false_balls = 0.03}, 8);
  ASSERT_TRUE(report.figure("noise.roll"));
  EXPECT_NEAR(report.figure("noise.roll")->value, 0.018, 0.0018);
  EXPECT_NEAR(report.figure("noise.tilt")->value, 0.015, 0.0015);
}

TEST(BallNoise, ImagesHeldOutAreCoveredAsPromisedAndScoreBetterThanBefore) {
  const Report report = noise_of({}, 9);
  const auto score = [&](const std::string& name) {
    const auto found = std::ranges::find(report.scores, name, [](const auto& pair) { return pair.first; });
    return found == report.scores.end() ? NAN : found->second;
  };
  EXPECT_NEAR(score("covered_90"), 0.9, 0.025);
  EXPECT_GT(score("log_score"), score("log_score_before"));
}

TEST(BallNoise, TheOrderOfTheRecordingsDoesNotMatter) {
  SightsOfGames games = planted_sights({.episodes = 8}, 10);
  const Report one = fit_ball_noise(beside_truth(games.seen), usual_models());
  std::ranges::reverse(games.seen);
  const Report other = fit_ball_noise(beside_truth(games.seen), usual_models());
  ASSERT_TRUE(one.figure("noise.roll") && other.figure("noise.roll"));
  EXPECT_NEAR(one.figure("noise.roll")->value, other.figure("noise.roll")->value, 1e-9);
}

/// Reflects a game at the x axis.
void mirror(SightsOfGames& games) {
  for (std::size_t i = 0; i < games.robots.size(); ++i) {
    auto game = std::make_shared<TrueGame>(*games.robots[i]->game);
    for (lab::PlaceAt& place : game->record.ball) place.y = -place.y;
    for (lab::PlaceAt& place : games.robots[i]->path) place.y = -place.y, place.heading = -place.heading;
    games.robots[i]->game = game;
    for (SeenBall& ball : games.seen[i].percepts) ball.bearing = -ball.bearing;
  }
}

TEST(BallNoise, AMirroredFieldGivesTheSame) {
  SightsOfGames games = planted_sights({.episodes = 8}, 11);
  const Report one = fit_ball_noise(beside_truth(games.seen), usual_models());
  mirror(games);
  const Report other = fit_ball_noise(beside_truth(games.seen), usual_models());
  ASSERT_TRUE(one.figure("noise.roll") && other.figure("noise.roll"));
  EXPECT_NEAR(one.figure("noise.roll")->value, other.figure("noise.roll")->value, 1e-9);
  EXPECT_NEAR(one.figure("noise.tilt")->value, other.figure("noise.tilt")->value, 1e-9);
}

TEST(BallNoise, WithoutHeadingsTheRollIsKept) {
  const Report report = noise_of({.has_heading = false}, 12);
  EXPECT_TRUE(report.figure("noise.tilt"));
  EXPECT_FALSE(report.figure("noise.roll"));
  ASSERT_EQ(report.kept.size(), 1u);
  EXPECT_EQ(report.kept[0], "noise.roll: expected headings of the robots in the truth, got no heading");
}

TEST(BallNoise, WithoutMotionStatusTheTiltsAreKept) {
  const Report report = noise_of({.has_gait = false, .episodes = 6}, 13);
  EXPECT_FALSE(report.figure("noise.tilt"));
  ASSERT_FALSE(report.kept.empty());
  EXPECT_EQ(report.kept[0], "noise.tilt: expected the motion status of the robots, got no message");
}

TEST(BallNoise, TooFewImagesAreRefusedWithTheirNumber) {
  const Report report = noise_of({.recordings = 1, .episodes = 1}, 14);
  EXPECT_TRUE(report.empty());
  ASSERT_EQ(report.kept.size(), 3u);
  EXPECT_EQ(report.kept[1],
            "noise.tilt_walking: expected at least 40 images of a ball that lies, by a robot that moves, in 8 passes, "
            "got 0 in 0");
  EXPECT_FALSE(report.needs.empty());
}

TEST(BallNoise, NothingIsKeptWithAReason) {
  const Report report = fit_ball_noise(Evidence{}, usual_models());
  EXPECT_TRUE(report.empty());
  EXPECT_EQ(report.kept.size(), 3u);
  EXPECT_EQ(report.needs.size(), 3u);
}

TEST(BallNoise, DrawsThePerceptsAndKeepsThemInATable) {
  const Report report = noise_of({}, 15);
  ASSERT_EQ(report.pictures.size(), 2u);
  for (const Picture& picture : report.pictures)
    for (const Mark& mark : picture.marks) {
      EXPECT_EQ(mark.x.size(), mark.y.size());
      EXPECT_FALSE(mark.x.empty());
    }
  ASSERT_EQ(report.tables.size(), 1u);
  for (const Table::Row& row : report.tables[0].second.rows)
    ASSERT_EQ(row.values.size(), report.tables[0].second.columns.size());
  for (const Results& results : report.results)
    for (const auto& row : results.rows) EXPECT_EQ(row.size(), results.head.size());
  EXPECT_NE(to_text(report).find("noise.pixels stays"), std::string::npos);
}

}  // namespace
}  // namespace robot::fit
