#include "robot/fit/ball_noise/ball_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "robot/fit/ball_noise/ball_noise.h"
#include "robot/fit/ball_noise/latency.h"
#include "robot/fit/ball_noise/profile.h"
#include "robot/fit/ball_noise/true_path.h"
#include "sim/io/matchup.h"
#include "tests/support/planted_sights.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

/// A path with a constant acceleration and noise.
lab::Path noisy_path(double error, double heading_error = 0) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  lab::Path path;
  for (int i = 0; i < 600; ++i) {
    const double at = i / 30.;
    path.push_back({.at = at,
                    .x = at - 0.02 * at * at + error * normal(random),
                    .y = 0.5 * at + error * normal(random),
                    .heading = std::remainder(3 + 0.1 * at + heading_error * normal(random), 2 * std::numbers::pi)});
  }
  return path;
}

sim::Models expected_models() {
  const auto game = sim::io::prepare({});
  EXPECT_TRUE(game);
  return game->params.teams[0].models;
}

TEST(TruePath, GivesPlaceSpeedAndHeadingBetweenThePlaces) {
  const lab::Path path = noisy_path(0);
  const auto moment = TruePath(path, kBallCurve).at(5.01);
  ASSERT_TRUE(moment);
  EXPECT_NEAR(moment->x, 5.01 - 0.02 * 5.01 * 5.01, 1e-6);
  EXPECT_NEAR(moment->speed_x, 1 - 0.04 * 5.01, 1e-6);
  EXPECT_NEAR(moment->bend, 0.04, 1e-5);
  EXPECT_NEAR(moment->heading, std::remainder(3 + 0.501, 2 * std::numbers::pi), 1e-6) << "it does not jump at π";
  EXPECT_NEAR(moment->turn_rate, 0.1, 1e-6);
}

TEST(TruePath, HasLessNoiseThanASinglePlaceByItsShare) {
  const lab::Path path = noisy_path(0.02);
  const TruePath curve(path, kBallCurve);
  double squares = 0, shares = 0;
  int count = 0;
  for (double at = 1; at < 19; at += 0.037, ++count) {
    const auto moment = curve.at(at);
    ASSERT_TRUE(moment);
    squares += std::pow(moment->y - 0.5 * at, 2);
    shares += moment->share * 0.02 * 0.02;
  }
  EXPECT_LT(shares / count, 0.5 * 0.02 * 0.02);
  EXPECT_NEAR(std::sqrt(squares / shares), 1, 0.15);
}

TEST(TruePath, TakesMoreTimeIfPlacesAreRare) {
  lab::Path path, all = noisy_path(0);
  for (std::size_t i = 0; i < all.size(); i += 3) path.push_back(all[i]);
  const TruePath curve(path, kRobotCurve);
  for (double at = 1; at < 18; at += 0.013) {
    const auto moment = curve.at(at);
    ASSERT_TRUE(moment) << at;
    EXPECT_NEAR(moment->x, at - 0.02 * at * at, 1e-6);
  }
}

TEST(TruePath, HasNothingBeyondTheEndsAndInGaps) {
  lab::Path path = noisy_path(0);
  std::erase_if(path, [](const lab::PlaceAt& place) { return place.at > 5 && place.at < 6; });
  const TruePath curve(path, kBallCurve);
  EXPECT_FALSE(curve.at(-0.1));
  EXPECT_FALSE(curve.at(5.5));
  EXPECT_FALSE(curve.at(25));
  EXPECT_TRUE(curve.at(4));
  EXPECT_FALSE(TruePath(lab::Path{}, kBallCurve).at(1));
}

TEST(TruthError, TheScatterIsThatOfThePlaces) {
  EXPECT_NEAR(scatter_of_places(noisy_path(0.02)), 0.02, 0.002);
  EXPECT_LT(scatter_of_places(noisy_path(0)), 1e-5);
  const lab::Path path = noisy_path(0, 0.03);
  EXPECT_NEAR(scatter_of_headings(path, std::vector<bool>(path.size(), true)), 0.03, 0.004);
  EXPECT_EQ(scatter_of_places({}), 0);
}

TEST(TruthError, AScatterlessTruthIsExactAndOthersHaveASharedPart) {
  EXPECT_EQ(truth_error(0.02, 0, 0).shared, 0);
  EXPECT_NEAR(truth_error(0.02, 0.012, 0.012).shared, 0.016, 1e-9);
  EXPECT_EQ(truth_error(0.02, 0.03, 0.03).shared, 0);
}

TEST(WritingTime, IsTheMedianIfItSaysAnything) {
  EXPECT_NEAR(*writing_time(std::vector<double>(50, 0.03)), 0.03, 1e-12);
  EXPECT_FALSE(writing_time(std::vector<double>(50, 0))) << "the writer repeats the capture time";
  EXPECT_FALSE(writing_time(std::vector<double>(50, 2))) << "written afterwards";
  EXPECT_FALSE(writing_time(std::vector<double>(19, 0.03)));
  std::vector<double> some(50, 0.03);
  for (std::size_t i = 0; i < 10; ++i) some[i] = -1;
  EXPECT_FALSE(writing_time(some));
}

TEST(PassesOfPlaces, EndAtPausesAndRecordingsAndAfterTwoSeconds) {
  std::vector<BallPlace> places;
  for (int i = 0; i < 90; ++i) places.push_back({.recording = 0, .at = i / 30.});
  places.push_back({.recording = 0, .at = 4});
  places.push_back({.recording = 1, .at = 4.1});
  EXPECT_EQ(passes_of(places, all_of(places.size())).size(), 4u);
  EXPECT_EQ(passes_of(places, all_of(places.size()), 3).size(), 3u) << "successive ones of a recording are joined";
}

TEST(MiddleOf, IsTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(middle_of({1, 4, 2, 3}), 2.5);
  EXPECT_EQ(middle_of({}), 0);
}

TEST(BallPlaces, BallsThatTheTruthDoesNotHaveAreCounted) {
  tests::SightsOfGames games = tests::planted_sights({.recordings = 1, .episodes = 2}, 1);
  games.seen[0].percepts.push_back({.capture_ns = 5'000'000'000'000, .distance = 1});
  const std::size_t all = games.seen[0].percepts.size();
  const BallPlaces places = beside_truth(games.seen);
  EXPECT_GE(places.without_truth, 1u);
  EXPECT_EQ(places.percepts.size() + places.without_truth, all);
  EXPECT_EQ(places.headless, 0u);
}

TEST(BallPlaces, NumbersThatCannotBeAreCountedAndDoNotSpread) {
  tests::SightsOfGames games = tests::planted_sights({.recordings = 2, .episodes = 12}, 2);
  const sim::Models base = expected_models();
  const Report clean = fit_ball_noise(beside_truth(games.seen), base);
  for (std::size_t i = 0; i < 20; ++i) {
    const std::uint64_t at = games.seen[0].percepts[40 * i].capture_ns;
    games.seen[0].percepts.push_back({.capture_ns = at, .distance = NAN});
    games.seen[0].percepts.push_back({.capture_ns = at, .distance = 1, .bearing = INFINITY});
    games.seen[0].beliefs.push_back({.capture_ns = at, .distance = -1});
  }
  const BallPlaces places = beside_truth(games.seen);
  EXPECT_EQ(places.damaged, 60u);
  const Report report = fit_ball_noise(places, base);
  ASSERT_EQ(report.figures.size(), clean.figures.size());
  for (std::size_t i = 0; i < report.figures.size(); ++i) EXPECT_EQ(report.figures[i].value, clean.figures[i].value);
}

TEST(BallPlaces, OfASimulatedGameGiveItsNoiseAndItsLatency) {
  const ::tests::TemporaryFolder folder;
  const Evidence evidence = tests::simulated_robots(
      folder.path() / "game",
      {.models = "match,noise.tilt=0.013,noise.tilt_walking=0.024,noise.roll=0.028,camera.latency=0.1", .seconds = 60});
  for (const WatchedRobot& robot : evidence.robots) EXPECT_EQ(robot.clock_by, "") << "the truth is in its recording";
  const BallPlaces places = read_ball_places(evidence);
  EXPECT_EQ(places.damaged, 0u);
  EXPECT_GT(places.beliefs.size(), 500u);
  const sim::Models base = expected_models();
  const auto value = [](const Report& report, const std::string& name) {
    const auto found = std::ranges::find(report.figures, name, &Figure::name);
    return found == report.figures.end() ? NAN : found->value;
  };
  const Report noise = fit_ball_noise(places, base);
  EXPECT_NEAR(value(noise, "noise.tilt_walking"), 0.024, 0.002);
  EXPECT_NEAR(value(noise, "noise.roll"), 0.028, 0.002);
  EXPECT_NEAR(value(fit_latency(places, base), "latency.percept"), 0.1, 0.02);
}

}  // namespace
}  // namespace robot::fit
