#include "sim/statistics/sample.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sim::statistics {
namespace {

TEST(Sample, AnEmptyListIsNotMeasured) {
  EXPECT_TRUE(std::isnan(mean_of({})));
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  EXPECT_TRUE(std::isnan(Share{}.value()));
}

TEST(Sample, AQuantileLiesBetweenTwoValues) {
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0), 1);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 1), 4);
  EXPECT_DOUBLE_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_DOUBLE_EQ(quantile({0, 10}, 0.9), 9);
  EXPECT_DOUBLE_EQ(median({7}), 7);
}

TEST(Sample, AShareIsHitsOfCases) {
  Share share;
  for (const bool hit : {true, false, false, true, false}) share.add(hit);
  EXPECT_DOUBLE_EQ(share.value(), 0.4);
}

}  // namespace
}  // namespace sim::statistics
