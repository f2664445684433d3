#include "robot/truth/tracks/estimate.h"

#include <gtest/gtest.h>

#include "robot/truth/tracks/motion.h"
#include "tests/robot/truth/tracks/images.h"
#include "tests/support/truth_walk.h"

namespace robot::truth {
namespace {

TEST(Estimate, HasHonestCovariancesOnlineAndSmoothed) {
  constexpr int runs = 80;
  constexpr std::size_t images = 12;
  test::Random random(11);
  for (const std::vector<double>& deviations : {std::vector<double>{0.}, {0.03}, {0.02, 0.05}}) {
    double online = 0, after = 0;
    for (int i = 0; i < runs; ++i) {
      const test::Walk walk = test::walk_of(deviations, images, random);
      online += test::normalised_error(walk.online.back(), walk.truth.back()) / runs;
      after += test::normalised_error(test::smoothed_walk(walk)[images / 2], walk.truth[images / 2]) / runs;
    }
    // the band of 95 % of a mean of `runs` values with mean 4 and variance 8
    const double band = 1.96 * std::sqrt(8. / runs);
    EXPECT_NEAR(online, 4, band);
    EXPECT_NEAR(after, 4, band);
  }
}

TEST(Estimate, IsBetterSmoothedThanOnline) {
  test::Random random(12);
  double online = 0, after = 0;
  for (int i = 0; i < 20; ++i) {
    const test::Walk walk = test::walk_of({0.}, 20, random);
    online += (walk.online[10].velocity() - walk.truth[10].segment<2>(2)).squaredNorm();
    after += (test::smoothed_walk(walk)[10].velocity() - walk.truth[10].segment<2>(2)).squaredNorm();
    EXPECT_LT(test::smoothed_walk(walk)[10].velocity_covariance().trace(),
              walk.online[10].velocity_covariance().trace());
  }
  EXPECT_LT(after, 0.6 * online);
}

TEST(Estimate, DoesNotAverageASharedErrorAway) {
  test::Random random(13);
  const test::Walk walk = test::walk_of({0.03}, 150, random);
  EXPECT_GT(walk.online.back().position_covariance()(0, 0), 0.8 * 0.03 * 0.03);
}

TEST(Estimate, OfTwoSensorsHasTheErrorThatTheoryGives) {
  test::Random random(14);
  // two equal shared errors: half the covariance. The rest is the noise of the measurements, as if there were no shared error.
  const double noise = test::walk_of({0., 0.}, 90, random).online.back().position_covariance()(0, 0);
  const double one = test::walk_of({0.05}, 90, random).online.back().position_covariance()(0, 0) - noise;
  const double two = test::walk_of({0.05, 0.05}, 90, random).online.back().position_covariance()(0, 0) - noise;
  EXPECT_NEAR(two / one, 0.5, 0.06);
}

TEST(Correct, MovesAnEstimateByAnOutlierNoFartherThanTheGate) {
  Estimate near = first_estimate({0, seen_at(0, 0)}, no_errors(), kRobotSpeed), far = near;
  correct(near, {0, seen_at(0.113, 0)}, 16);  // 4 deviations of two equal errors
  correct(far, {0, seen_at(1, 0)}, 16);
  EXPECT_NEAR(near.position().x(), 0.113 / 2, 0.001);
  EXPECT_LT(far.position().x(), near.position().x());
}

TEST(Innovation, IsTheDifferenceFromTheExpectedPlace) {
  const Estimate estimate = first_estimate({0, seen_at(1, 1)}, no_errors(), kRobotSpeed);
  const Innovation found = innovation(estimate, {0, seen_at(1.02, 1)});
  EXPECT_NEAR(found.distance_squared, 0.5, 1e-9);
  EXPECT_NEAR(found.covariance(0, 0), 8e-4, 1e-12);
  EXPECT_NEAR(expected_place(estimate, 0).position.x(), 1, 1e-12);
}

}  // namespace
}  // namespace robot::truth
