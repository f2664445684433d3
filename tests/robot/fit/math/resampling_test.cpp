#include "robot/fit/math/resampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::fit {
namespace {

// a table of Student's distribution, 97.5 %
TEST(TwoSided, EqualsTheTable) {
  EXPECT_NEAR(two_sided(1), 12.706, 0.001);
  EXPECT_NEAR(two_sided(2), 4.303, 0.001);
  EXPECT_NEAR(two_sided(3), 3.182, 0.03);
  EXPECT_NEAR(two_sided(5), 2.571, 0.004);
  EXPECT_NEAR(two_sided(10), 2.228, 0.001);
  EXPECT_NEAR(two_sided(30), 2.042, 0.001);
  EXPECT_NEAR(two_sided(10'000), 1.960, 0.001);
}

Vector mean_of(const std::vector<std::size_t>& observations) {
  double sum = 0;
  for (const std::size_t i : observations) sum += static_cast<double>(i % 10);
  return {sum / static_cast<double>(observations.size())};
}

TEST(Resampled, TheMeanScattersAsStatisticsSay) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < 200; ++i) groups.push_back({i});
  // the digits 0 .. 9 have the variance 8.25
  EXPECT_NEAR(deviations_of(resampled(groups, 2000, mean_of))[0], std::sqrt(8.25 / 200), 0.01);
}

TEST(Resampled, ObservationsOfOneGroupShareTheirLuck) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < 200; ++i) groups.push_back({i, i, i, i});
  EXPECT_NEAR(deviations_of(resampled(groups, 2000, mean_of))[0], std::sqrt(8.25 / 200), 0.01)
      << "four equal observations are one";
}

TEST(Resampled, IsTheSameAgain) {
  const std::vector<Group> groups{{0}, {1}, {2}, {3}};
  EXPECT_EQ(resampled(groups, 20, mean_of), resampled(groups, 20, mean_of));
}

}  // namespace
}  // namespace robot::fit
