#include "robot/fit/localisation/variance_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace robot::fit {
namespace {

/// Errors whose variance is 0.04 way + 0.01, on two axes.
std::vector<SquaredError> errors_of(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<SquaredError> errors;
  for (std::size_t i = 0; i < count; ++i) {
    const double way = static_cast<double>(i % 5) / 2, deviation = std::sqrt(0.04 * way + 0.01);
    const double x = deviation * normal(random), y = deviation * normal(random);
    errors.push_back({.squares = x * x + y * y, .freedom = 2, .amounts = {way, 1, 0}});
  }
  return errors;
}

TEST(VarianceParts, TheFactorsOfNormalErrorsAreFound) {
  const auto errors = errors_of(4000, 1);
  const VarianceParts fit = fit_variances(errors, 2);
  EXPECT_NEAR(fit.factors[0], 0.04, 0.004);
  EXPECT_NEAR(fit.factors[1], 0.01, 0.001);
  EXPECT_NEAR(fit.variance_of({.amounts = {2, 1, 0}}), 0.09, 0.008);
}

TEST(VarianceParts, ErrorsBeyondFourDeviationsHardlyCount) {
  auto errors = errors_of(1000, 2);
  const double before = fit_variances(errors, 2).factors[0];
  for (std::size_t i = 0; i < 20; ++i) errors[50 * i + 3].squares = 9;
  EXPECT_NEAR(fit_variances(errors, 2).factors[0], before, 0.06 * before);
}

TEST(VarianceParts, APartThatNoEventHasIsZeroWithAnInfiniteDeviation) {
  const VarianceParts fit = fit_variances(errors_of(200, 3), 3);
  EXPECT_EQ(fit.factors[2], 0);
  EXPECT_TRUE(std::isinf(fit.deviations[2]));
  EXPECT_TRUE(fit_variances({}, 2).factors[0] == 0);
}

TEST(VarianceParts, ErrorsThatAreNotFiniteAreLeftOut) {
  auto errors = errors_of(500, 4);
  const double before = fit_variances(errors, 2).factors[0];
  errors.push_back({.squares = NAN, .freedom = 2, .amounts = {1, 1, 0}});
  errors.push_back({.squares = 1, .freedom = 2, .amounts = {INFINITY, 1, 0}});
  EXPECT_EQ(fit_variances(errors, 2).factors[0], before);
}

TEST(VarianceParts, AKnownVarianceIsTakenOff) {
  auto errors = errors_of(4000, 5);
  for (SquaredError& error : errors) error.amounts = {error.amounts[0], 0, 0}, error.known = 0.01;
  EXPECT_NEAR(fit_variances(errors, 1).factors[0], 0.04, 0.004);
}

TEST(VarianceParts, IntervalsCoverTheRootsOfTheFactors) {
  int covered = 0;
  for (std::uint64_t seed = 10; seed < 30; ++seed) {
    const auto errors = errors_of(200, seed);
    const auto roots = root_intervals(errors, single_groups(errors.size()), 2, fit_variances(errors, 2));
    covered += roots[0].low <= 0.2 && 0.2 <= roots[0].high;
    covered += roots[1].low <= 0.1 && 0.1 <= roots[1].high;
  }
  EXPECT_GE(covered, 34);
}

TEST(VarianceParts, FewErrorsHaveARelativeInterval) {
  int covered = 0;
  for (std::uint64_t seed = 10; seed < 30; ++seed) {
    auto errors = errors_of(10, seed);
    for (SquaredError& error : errors) error.squares /= 0.04 * error.amounts[0] + 0.01, error.amounts = {1, 0, 0};
    const RootInterval root = relative_interval(errors, fit_variances(errors, 1));
    covered += root.low <= 1 && 1 <= root.high;
    EXPECT_GT(root.low, 0);
  }
  EXPECT_GE(covered, 18);
}

}  // namespace
}  // namespace robot::fit
