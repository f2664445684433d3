#include "robot/lab/clocks/robust_line.h"

#include <gtest/gtest.h>

namespace robot::lab {
namespace {

/// Points of value = 3 + 2 x, with some far outliers.
std::vector<LinePoint> points_with_outliers() {
  std::vector<LinePoint> points;
  for (int i = 0; i < 100; ++i) {
    const double x = i * 0.1, outlier = i % 10 == 0 ? 50 : 0, noise = (i % 2 == 0 ? 0.1 : -0.1);
    points.push_back({.one = 1, .x = x, .value = 3 + 2 * x + noise + outlier});
  }
  return points;
}

TEST(RobustLine, OutliersHardlyMoveIt) {
  const Line line = fitted(points_with_outliers());
  EXPECT_NEAR(line.bias, 3, 0.1);
  EXPECT_NEAR(line.slope, 2, 0.02);
}

TEST(RobustLine, ItsLossIsThatOfThePointsAtTheLineOfTheSumsAndNoLessNearby) {
  const auto points = points_with_outliers();
  const Line line = fitted(points);
  LossSums sums;
  double all = 0;
  for (const LinePoint& point : points) sums.add(point, line), all += loss(line.residual(point));
  EXPECT_NEAR(sums.loss_of(line), all, 1e-9 * all);
  for (const Line& other : {Line{line.bias + 0.3, line.slope}, Line{line.bias, line.slope - 0.1}}) {
    double others = 0;
    for (const LinePoint& point : points) others += loss(other.residual(point));
    EXPECT_GE(sums.loss_of(other), others) << "the parabola lies above the loss";
    EXPECT_GT(others, all);
  }
}

TEST(RobustLine, SumsOfPartsAreTheSumsOfAll) {
  const auto points = points_with_outliers();
  LossSums all, odd, even, joined;
  for (std::size_t i = 0; i < points.size(); ++i) {
    all.add(points[i], {.bias = 3, .slope = 2});
    (i % 2 == 0 ? even : odd).add(points[i], {.bias = 3, .slope = 2});
  }
  joined.add(odd, 1), joined.add(even, 1);
  EXPECT_NEAR(joined.best().slope, all.best().slope, 1e-12);
  EXPECT_NEAR(joined.loss_of({.bias = 1, .slope = 1}), all.loss_of({.bias = 1, .slope = 1}), 1e-9);
}

TEST(RobustLine, WithoutASpreadOfXTheSlopeIsZero) {
  const Line line = fitted({{1, 2, 7}, {1, 2, 7}, {1, 2, 7}});
  EXPECT_EQ(line.slope, 0);
  EXPECT_NEAR(line.bias, 7, 1e-9);
  EXPECT_EQ(fitted({}).slope, 0);
  EXPECT_EQ(fitted({}).bias, 0);
}

TEST(RobustLine, TheLossOfSmallResidualsIsHalfTheSquare) {
  EXPECT_NEAR(loss(0.01), 0.00005, 1e-8);
  EXPECT_EQ(loss(0), 0);
  EXPECT_LT(loss(100), 20);
}

}  // namespace
}  // namespace robot::lab
