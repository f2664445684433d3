#include "robot/lab/clocks/lag_profile.h"

#include <gtest/gtest.h>

#include "tests/support/planted_offset.h"

namespace robot::lab {
namespace {

using Everywhere = LagProfile::Everywhere;

TEST(Lags, CoverTheReachOnBothSides) {
  const Lags lags = Lags::around(1, 0.3, 0.1);
  ASSERT_EQ(lags.count, 7u);
  EXPECT_NEAR(lags.at(0), 0.7, 1e-12);
  EXPECT_NEAR(lags.at(3), 1, 1e-12);
  EXPECT_NEAR(lags.at(6), 1.3, 1e-12);
}

TEST(Cells, TimeWithoutAValueBelongsToNone) {
  const Cells cells({{.at = 10}, {.at = 11}, {.at = 13}, {.at = 1e9}}, 2, 100);
  ASSERT_EQ(cells.count(), 3u);
  EXPECT_EQ(cells.of(10), 0u);
  EXPECT_EQ(cells.of(11), 0u);
  EXPECT_EQ(cells.of(13), 1u);
  EXPECT_EQ(cells.of(1e9), 2u);
}

TEST(Cells, TooManyAreJoined) {
  Series series;
  for (int i = 0; i < 10; ++i) series.push_back({.at = i * 2.0});
  const Cells cells(series, 2, 4);
  ASSERT_EQ(cells.count(), 4u);
  EXPECT_EQ(cells.of(4), 0u);
  EXPECT_EQ(cells.of(6), 1u);
  EXPECT_EQ(cells.of(18), 3u);
}

TEST(LagProfile, ItsGreatestGainIsAtThePlantedLag) {
  const auto distance = tests::shared_distance(tests::planted_distances({.seconds = 40, .offset = 0.24}));
  const LagProfile profile(distance, Lags::around(0, 1, 0.02), Cells(distance.seen, 2, 100), Everywhere::yes);
  EXPECT_NEAR(best_lag(profile.lags(), profile.gains()).value(), 0.24, 0.04);
  EXPECT_GT(profile.values(), 800u);
}

TEST(LagProfile, OnlyValuesWithATruthAtEveryLagCountEverywhere) {
  auto planted = tests::planted_distances({.seconds = 40});
  std::erase_if(planted.truth, [](const Sample& sample) { return sample.at > 10 && sample.at < 20; });
  const auto distance = tests::shared_distance(planted);
  const auto values = [&](Everywhere everywhere) {
    return LagProfile(distance, Lags::around(0, 2, 0.1), Cells(distance.seen, 2, 100), everywhere).values();
  };
  EXPECT_LT(values(Everywhere::yes), values(Everywhere::no));
}

TEST(LagProfile, CellsThatCountNotAreAsIfTheyWereNotThere) {
  const auto distance = tests::shared_distance(tests::planted_distances({.seconds = 20}));
  const Lags lags = Lags::around(0, 0.1, 0.05);
  const LagProfile whole(distance, lags, Cells(distance.seen, 12, 100), Everywhere::no);
  const auto none = whole.gains({0, 0}), twice = whole.gains({2, 2}), once = whole.gains();
  for (std::size_t i = 0; i < lags.count; ++i) {
    EXPECT_EQ(none[i], 0);
    EXPECT_NEAR(twice[i], 2 * once[i], 1e-6);
  }
}

TEST(LagProfile, AnUnlikelySlopeHasNoGain) {
  auto distance = tests::shared_distance(tests::planted_distances({.seconds = 20}));
  for (Sample& sample : distance.seen) sample.value = 3 - sample.value;
  const LagProfile profile(distance, Lags::around(0, 0, 0.1), Cells(distance.seen, 2, 100), Everywhere::no);
  EXPECT_EQ(profile.gains(), std::vector<double>{0});
}

TEST(BestLag, IsBetweenTheLagsAndNotAtTheBorder) {
  const Lags lags{.first = 0, .step = 1, .count = 4};
  EXPECT_NEAR(best_lag(lags, {0, 3, 4, 3}).value(), 2, 1e-12);
  EXPECT_NEAR(best_lag(lags, {0, 4, 4, 0}).value(), 1.5, 1e-12);
  EXPECT_FALSE(best_lag(lags, {4, 3, 2, 1}));
  EXPECT_FALSE(best_lag(lags, {1, 2, 3, 4}));
  EXPECT_FALSE(best_lag(lags, {0, 0, 0, 0}));
  EXPECT_FALSE(best_lag({.first = 0, .step = 1, .count = 0}, {}));
}

}  // namespace
}  // namespace robot::lab
