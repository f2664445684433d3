#include "robot/fit/math/simplex.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::fit {
namespace {

TEST(LeastOf, FindsTheValleyOfRosenbrock) {
  const auto value = [](const Vector& p) { return std::pow(1 - p[0], 2) + 100 * std::pow(p[1] - p[0] * p[0], 2); };
  const Vector found = least_of(value, {-1.2, 1}, {0.1, 0.1});
  EXPECT_NEAR(found[0], 1, 0.02);
  EXPECT_NEAR(found[1], 1, 0.04);
}

TEST(LeastOf, InfinityAndNoNumberAreBounds) {
  const auto value = [](const Vector& p) { return p[0] < 2 ? (p[0] < 1 ? NAN : INFINITY) : p[0]; };
  EXPECT_NEAR(least_of(value, {5}, {1})[0], 2, 0.01);
}

}  // namespace
}  // namespace robot::fit
