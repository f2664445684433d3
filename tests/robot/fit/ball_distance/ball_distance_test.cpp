#include "robot/fit/ball_distance/ball_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/planted_balls.h"

namespace robot::fit {
namespace {

using tests::planted_balls;

/// Returns the mean error over all distances [m].
double mean_error(const BallDistance& fit, const std::string& curve) {
  for (const HeldOut& errors : fit.held_out)
    if (errors.is_whole && errors.curve == curve) return errors.errors.mean;
  ADD_FAILURE() << "no errors of " << curve;
  return 0;
}

TEST(BallDistance, IntervalsCoverThePlantedCamera) {
  int covered[3] = {};
  constexpr int kTimes = 12;
  for (std::uint64_t seed = 1; seed <= kTimes; ++seed) {
    const auto fit = fit_ball_distance(planted_balls({}, seed));
    ASSERT_TRUE(fit) << fit.error();
    const double planted[3] = {24.2, 0.7, 0.41};
    for (std::size_t i = 0; i < 3; ++i)
      covered[i] += planted[i] >= fit->figures[i].low && planted[i] <= fit->figures[i].high;
  }
  // 95 % of 12; scripts/bench fit counts a hundred
  for (const int count : covered) EXPECT_GE(count, 10);
}

TEST(BallDistance, IsBetterThanThePowerLawAndAConstantOnImagesHeldOut) {
  const auto fit = fit_ball_distance(planted_balls({}, 7));
  ASSERT_TRUE(fit) << fit.error();
  EXPECT_LT(mean_error(*fit, "pinhole"), mean_error(*fit, "power law"));
  EXPECT_LT(mean_error(*fit, "power law"), mean_error(*fit, "constant"));
  EXPECT_EQ(fit->parts, "each fifth of the passes");
  EXPECT_EQ(by_curve(fit->held_out).size(), 4u) << "three curves and the robot's own";
}

TEST(BallDistance, LongRecordingsAreThinnedWithoutLosingAPass) {
  BallSizes seen = planted_balls({}, 7);
  std::vector<Group> passes = passes_of(seen.sizes);
  const std::size_t images = seen.sizes.size(), before = passes.size();
  const std::vector<BallSize> all = seen.sizes;
  std::vector<BallSize> first;
  for (const Group& pass : passes) first.push_back(all[pass.front()]);
  thin(seen, passes, images);
  EXPECT_EQ(seen.sizes.size(), images) << "few enough";
  thin(seen, passes, images / 4);
  EXPECT_LE(seen.sizes.size(), images / 4 + before);
  EXPECT_EQ(seen.sizes.size() + seen.thinned, images);
  ASSERT_EQ(passes.size(), before);
  for (std::size_t i = 0; i < passes.size(); ++i) EXPECT_EQ(seen.sizes[passes[i].front()].at, first[i].at);
}

TEST(BallDistance, NothingIsKnownOutsideItsDomain) {
  const auto fit = fit_ball_distance(planted_balls({}, 7));
  ASSERT_TRUE(fit) << fit.error();
  EXPECT_FALSE(fit->distance(fit->least_radius - 0.1));
  EXPECT_FALSE(fit->distance(fit->most_radius + 0.1));
  EXPECT_FALSE(fit->distance(NAN));
  EXPECT_TRUE(fit->distance((fit->least_radius + fit->most_radius) / 2));
  EXPECT_NEAR(fit->figures[0].domain.from, 0.5, 0.1);
  EXPECT_NEAR(fit->figures[0].domain.to, 3, 0.15);
}

TEST(BallDistance, TheErrorOfAClockWidensTheInterval) {
  BallSizes sure = planted_balls({}, 5), unsure = sure;
  unsure.clock_deviation = {0.2};
  for (BallSize& size : sure.sizes) size.rate = std::abs(size.rate);
  for (BallSize& size : unsure.sizes) size.rate = std::abs(size.rate);  // all balls go away: the error has one sign
  const auto narrow = fit_ball_distance(sure), wide = fit_ball_distance(unsure);
  ASSERT_TRUE(narrow && wide);
  EXPECT_EQ(narrow->figures[0].value, wide->figures[0].value);
  EXPECT_GT(wide->figures[0].high - wide->figures[0].low, 1.1 * (narrow->figures[0].high - narrow->figures[0].low));
}

TEST(BallDistance, RecordingsAreHeldOutAsAWhole) {
  BallSizes seen = planted_balls({}, 1);
  const BallSizes other = planted_balls({}, 2);
  for (BallSize size : other.sizes) {
    size.recording = 1;
    seen.sizes.push_back(size);
  }
  seen.recordings.emplace_back("other");
  seen.clock_deviation.push_back(0);
  const auto fit = fit_ball_distance(seen);
  ASSERT_TRUE(fit) << fit.error();
  EXPECT_EQ(fit->parts, "each of 2 recordings");
  EXPECT_EQ(fit->figures[0].recordings.size(), 2u);
  EXPECT_EQ(table_of(*fit).rows.size(), seen.sizes.size());
  EXPECT_EQ(table_of(*fit).rows.front().values.size(), table_of(*fit).columns.size());
}

TEST(BallDistance, WhatCannotCarryAFitIsRefusedWithTheReason) {
  EXPECT_NE(fit_ball_distance({}).error().find("no image shows a ball"), std::string::npos);
  EXPECT_EQ(fit_ball_distance(planted_balls({.passes = 2, .images = 40}, 1)).error(),
            "expected at least 30 images with a ball in 5 passes, got 80 in 2");
  const auto spot = fit_ball_distance(planted_balls({.nearest = 1.1, .farthest = 1.15}, 1));
  ASSERT_FALSE(spot);
  EXPECT_NE(spot.error().find("expected distances that differ by a half or more"), std::string::npos) << spot.error();
}

TEST(BallDistance, IsTheSameAgain) {
  const auto one = fit_ball_distance(planted_balls({}, 9)), other = fit_ball_distance(planted_balls({}, 9));
  ASSERT_TRUE(one && other);
  EXPECT_EQ(to_text(*one), to_text(*other));
}

TEST(PassesOf, EndAtAPauseAtTwoSecondsAndWithTheRecording) {
  std::vector<BallSize> sizes;
  for (int i = 0; i < 100; ++i) sizes.push_back({.recording = 0, .at = i / 30.});  // 3.3 s
  sizes.push_back({.recording = 0, .at = 5});
  sizes.push_back({.recording = 1, .at = 5.01});
  const auto passes = passes_of(sizes);
  ASSERT_EQ(passes.size(), 4u);
  EXPECT_EQ(passes[0].size(), 60u);
  EXPECT_EQ(passes[1].size(), 40u);
  EXPECT_EQ(passes[2].size() + passes[3].size(), 2u);
}

}  // namespace
}  // namespace robot::fit
