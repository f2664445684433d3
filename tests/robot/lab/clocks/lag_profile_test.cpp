#include "robot/lab/clocks/lag_profile.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/planted_offset.h"

namespace robot::lab {
namespace {

TEST(Lags, CoverTheReachOnBothSides) {
  const Lags lags = Lags::around(1, 0.3, 0.1);
  ASSERT_EQ(lags.count, 7u);
  EXPECT_NEAR(lags.at(0), 0.7, 1e-12);
  EXPECT_NEAR(lags.at(3), 1, 1e-12);
  EXPECT_NEAR(lags.at(6), 1.3, 1e-12);
}

TEST(Cells, TimesOutsideBelongToTheFirstOrLastOne) {
  const Cells cells{.start = 10, .length = 2, .count = 3};
  EXPECT_EQ(cells.of(-5), 0u);
  EXPECT_EQ(cells.of(12.5), 1u);
  EXPECT_EQ(cells.of(1e300), 2u);
}

TEST(LagProfile, ItsGreatestGainIsAtThePlantedLag) {
  const auto quantity = tests::shared_distance(tests::planted_distances({.seconds = 40, .offset = 0.24}));
  LagProfile profile(Lags::around(0, 1, 0.02), {.start = 0, .length = 2, .count = 21});
  profile.add(quantity, true);
  EXPECT_NEAR(best_lag(profile.lags(), profile.gains()).value(), 0.24, 0.04);
  EXPECT_EQ(profile.values(0), profile.values(100)) << "everywhere: all lags explain the same values";
}

TEST(LagProfile, CellsThatCountNotAreAsIfTheyWereNotThere) {
  auto quantity = tests::shared_distance(tests::planted_distances({.seconds = 20}));
  const Cells cells{.start = 0, .length = 10, .count = 2};
  const Lags lags = Lags::around(0, 0.1, 0.05);
  LagProfile whole(lags, cells);
  whole.add(quantity, false);
  const auto none = whole.gains({0, 0}), twice = whole.gains({2, 2}), once = whole.gains();
  for (std::size_t i = 0; i < lags.count; ++i) {
    EXPECT_EQ(none[i], 0);
    EXPECT_NEAR(twice[i], 2 * once[i], 1e-6);
  }
}

TEST(LagProfile, AMirroredQuantityHasNoGain) {
  auto quantity = tests::shared_distance(tests::planted_distances({.seconds = 20}));
  for (Sample& seen : quantity.robot) seen.value = -seen.value;
  LagProfile profile(Lags::around(0, 0, 0.1), {.start = 0, .length = 100, .count = 1});
  profile.add(quantity, false);
  EXPECT_EQ(profile.gains(), std::vector<double>{0}) << "a slope below the least one is an accident";
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
