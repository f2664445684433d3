#include "robot/fit/math/counts.h"

#include <gtest/gtest.h>

namespace robot::fit {
namespace {

TEST(PoissonInterval, IsThatOfGarwood) {
  EXPECT_EQ(poisson_interval(0).low, 0);
  EXPECT_NEAR(poisson_interval(0).high, 3.689, 0.001);
  EXPECT_NEAR(poisson_interval(1).low, 0.0253, 0.0001);
  EXPECT_NEAR(poisson_interval(1).high, 5.572, 0.001);
  EXPECT_NEAR(poisson_interval(10).low, 4.795, 0.001);
  EXPECT_NEAR(poisson_interval(10).high, 18.39, 0.01);
  EXPECT_NEAR(poisson_interval(1000).low, 939, 1);
  EXPECT_NEAR(poisson_interval(1000).high, 1064, 1);
  EXPECT_NEAR(poisson_interval(400).low, 361, 1);
}

TEST(ExactShare, TheIntervalOfClopperAndPearson) {
  EXPECT_EQ(exact_share(0, 10).low, 0);
  EXPECT_NEAR(exact_share(0, 10).high, 0.3085, 1e-4);
  EXPECT_NEAR(exact_share(5, 10).low, 0.1871, 1e-4);
  EXPECT_NEAR(exact_share(5, 10).high, 0.8129, 1e-4);
  EXPECT_EQ(exact_share(10, 10).high, 1);
}

TEST(MeanDuration, CountsDurationsThatWereCutOff) {
  const MeanDuration mean = mean_duration(10, 150);
  EXPECT_EQ(mean.value, 15);
  EXPECT_NEAR(mean.low, 8.16, 0.01);
  EXPECT_NEAR(mean.high, 31.3, 0.1);
}

TEST(WilsonInterval, IsThatOfTheTables) {
  EXPECT_EQ(wilson_interval(0, 10, 1.96).low, 0);
  EXPECT_NEAR(wilson_interval(0, 10, 1.96).high, 0.2775, 1e-4);
  EXPECT_NEAR(wilson_interval(0.5, 10, 1.96).low, 0.2366, 1e-4);
  EXPECT_NEAR(wilson_interval(0.5, 10, 1.96).high, 0.7634, 1e-4);
  EXPECT_EQ(wilson_interval(1, 10, 1.96).high, 1);
}

}  // namespace
}  // namespace robot::fit
