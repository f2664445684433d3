#include "robot/fit/visibility/false_balls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/fit/math/counts.h"
#include "tests/support/planted_looks.h"

namespace robot::fit {
namespace {

using tests::planted_base, tests::planted_looks;

TEST(SightNoise, IsThatOfTheImagesAlsoBelowTheModels) {
  const sim::Models base = planted_base();
  for (const double planted : {0.005, 0.02, 0.05}) {
    const SightNoise noise = noise_of(planted_looks({.noise = planted, .heading_error = 0}, 4), base);
    EXPECT_NEAR(noise.walking, planted, 0.2 * planted);  // the robot of these looks always walks
  }
}

TEST(SightNoise, IsTheModelsWithFewPercepts) {
  const sim::Models base = planted_base();
  const SightNoise noise = noise_of(Looks{}, base);
  EXPECT_GE(noise.standing, base.perception.noise.tilt);
  EXPECT_GE(noise.walking, base.perception.noise.tilt_walking);
}

TEST(FalseBalls, IntervalsCoverThePlantedRateAndItIsNotBiased) {
  int covered = 0;
  double bias = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Report report = false_balls_of(planted_looks({}, seed), planted_base());
    ASSERT_EQ(report.figures.size(), 1u);
    const Figure& figure = report.figures[0];
    EXPECT_EQ(figure.name, "ball_filter.false_per_second");
    covered += figure.low <= 0.05 && figure.high >= 0.05;
    bias += (figure.value - 0.05) / (figure.high - figure.low) / 8;
  }
  EXPECT_GE(covered, 6) << "95 % of 8";
  EXPECT_LT(std::abs(bias), 0.33);
}

TEST(FalseBalls, AMirroredFieldGivesTheSame) {
  const auto figure = false_balls_of(planted_looks({}, 3), planted_base()).figures.at(0);
  const auto mirrored = false_balls_of(planted_looks({.mirrored = true}, 3), planted_base()).figures.at(0);
  EXPECT_NEAR(figure.value, mirrored.value, 1e-9);
  EXPECT_EQ(figure.events, mirrored.events);
}

TEST(FalseBalls, NoisyPerceptsOfTheBallAreNoFalseBalls) {
  const auto found = false_balls_in(planted_looks({.false_per_second = 0, .noise = 0.08}, 1), planted_base());
  EXPECT_LE(found.balls.size(), 1u);
}

TEST(FalseBalls, WithoutAnyTheValueIsZeroWithAnUpperEnd) {
  const auto figure = false_balls_of(planted_looks({.false_per_second = 0}, 1), planted_base()).figures.at(0);
  EXPECT_EQ(figure.value, 0);
  EXPECT_EQ(figure.low, 0);
  EXPECT_GT(figure.high, 0);
  EXPECT_TRUE(figure.is_known()) << "1000 s";
  const auto loose = false_balls_of(planted_looks({.false_per_second = 0, .seconds = 150}, 1), planted_base());
  EXPECT_FALSE(loose.figures.at(0).is_known()) << "150 s";
}

TEST(FalseBalls, ABallThatStaysIsOneEvent) {
  Looks looks = planted_looks({.false_per_second = 0}, 1);
  const auto far = std::ranges::find_if(
      looks.looks, [](const Look& look) { return look.at > 100 && !look.has_ball && look.across < -1; });
  for (auto look = far; look < far + 5; ++look)
    look->has_ball = true, look->seen_x = 2 * std::cos(look->axis), look->seen_y = 2 * std::sin(look->axis);
  const auto figure = false_balls_of(looks, planted_base()).figures.at(0);
  const double exposure = false_balls_in(looks, planted_base()).exposure;
  EXPECT_EQ(figure.events, 1u);
  EXPECT_NEAR(figure.value, 5 / exposure, 1e-9) << "each image counts for the rate";
  EXPECT_GT(figure.high, 25 / exposure) << "but not for the interval";
}

TEST(FalseBalls, TooLittleTimeIsRefused) {
  const Report report = false_balls_of(planted_looks({.seconds = 20}, 1), planted_base());
  EXPECT_TRUE(report.empty());
  ASSERT_EQ(report.kept.size(), 1u);
  EXPECT_EQ(
      report.kept[0].find("ball_filter.false_per_second: expected at least 60 seconds of images that show no true "
                          "ball, got "),
      0u);
  EXPECT_FALSE(report.needs.empty());
}

TEST(FalseBalls, WithoutHeadingsItSaysSo) {
  Looks looks;
  looks.without_heading = 9;
  const Report report = false_balls_of(looks, planted_base());
  ASSERT_EQ(report.kept.size(), 1u);
  EXPECT_EQ(report.kept[0], "ball_filter.false_per_second: the truth has no headings of the robots (9 images)");
}

TEST(FalseBalls, ThePictureShowsThemBesideTrueOnes) {
  const Report report = false_balls_of(planted_looks({}, 2), planted_base());
  ASSERT_EQ(report.pictures.size(), 1u);
  ASSERT_EQ(report.pictures[0].marks.size(), 2u);
  EXPECT_FALSE(report.pictures[0].marks[0].x.empty());
  EXPECT_LE(report.pictures[0].marks[0].x.size(), 1000u);
  EXPECT_EQ(report.pictures[0].marks[1].x.size(), report.tables.at(0).second.rows.size());
}

}  // namespace
}  // namespace robot::fit
