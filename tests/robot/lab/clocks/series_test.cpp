#include "robot/lab/clocks/series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace robot::lab {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Samples of a function, 30 a second.
Series samples_of(double (*function)(double), double from, double to) {
  Series series;
  for (double at = from; at < to; at += 1 / 30.0) series.push_back({.at = at, .value = function(at)});
  return series;
}

double parabola(double at) { return 1 + 2 * at - 0.5 * at * at; }

TEST(Tidied, FiniteSamplesAreInOrderAndTheFirstOfOneTimeCounts) {
  const Series tidy = tidied({{3, 1}, {1, 2}, {kNan, 3}, {2, kNan}, {1, 4}, {kInfinity, 5}, {2, -kInfinity}, {2, 6}});
  ASSERT_EQ(tidy.size(), 3u);
  EXPECT_EQ(tidy[0].at, 1);
  EXPECT_EQ(tidy[0].value, 2);
  EXPECT_EQ(tidy[1].at, 2);
  EXPECT_EQ(tidy[1].value, 6);
  EXPECT_EQ(tidy[2].at, 3);
  EXPECT_TRUE(tidied({}).empty());
}

TEST(SmoothCurve, AParabolaStaysAsItIs) {
  const SmoothCurve curve(samples_of(parabola, -1, 4));
  for (double at = -0.9; at < 3.9; at += 0.0173) {
    ASSERT_TRUE(curve.at(at)) << at;
    EXPECT_NEAR(*curve.at(at), parabola(at), 1e-4) << at;
    if (at > -0.8 && at < 3.8) {
      EXPECT_NEAR(curve.rate_at(at).value(), 2 - at, 1e-3) << at;
    }
  }
}

TEST(SmoothCurve, HasNoValueOutsideAndWithinALongGap) {
  Series series = samples_of(parabola, 0, 1);
  const Series later = samples_of(parabola, 2, 3);
  series.insert(series.end(), later.begin(), later.end());
  const SmoothCurve curve(series);
  for (const double at : {-0.01, 1.2, 1.99, 3.1, 1e300, -1e300, kNan}) EXPECT_FALSE(curve.at(at)) << at;
  EXPECT_TRUE(curve.at(0.5));
  EXPECT_TRUE(curve.at(2.5));
  EXPECT_FALSE(curve.rate_at(2.0)) << "half of it is in the gap";
  EXPECT_FALSE(SmoothCurve().at(0));
  EXPECT_FALSE(SmoothCurve(Series{}).at(0));
}

TEST(SmoothCurve, AShortGapIsBridged) {
  Series series = samples_of(parabola, 0, 2);
  std::erase_if(series, [](const Sample& sample) { return sample.at > 1 && sample.at < 1.1; });
  EXPECT_NEAR(SmoothCurve(series).at(1.05).value(), parabola(1.05), 1e-3);
}

TEST(SmoothCurve, FewerThanFourSamplesAreNoCurve) {
  EXPECT_FALSE(SmoothCurve({{0, 1}, {0.03, 1}, {0.06, 1}}).at(0.03));
}

TEST(SmoothCurve, SamplesFarApartAreNoLongCurve) { EXPECT_FALSE(SmoothCurve({{-1e18, 1}, {0, 1}, {1e18, 1}}).at(0.5)); }

}  // namespace
}  // namespace robot::lab
