#include "robot/truth/tracks/estimate.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "robot/truth/tracks/motion.h"
#include "tests/robot/truth/tracks/images.h"
#include "tests/support/truth_game.h"

namespace robot::truth {
namespace {

constexpr double kNoise = 0.02;            // [m]
constexpr double kWalkInterval = 1. / 30;  // [s]

SharedErrors errors_of(const std::vector<double>& deviations) {
  SharedErrors errors = no_errors();
  for (std::size_t i = 0; i < deviations.size(); ++i)
    errors[i] = deviations[i] * deviations[i] * Eigen::Matrix2d::Identity();
  return errors;
}

/// A robot that moves exactly as the filter expects, its offsets too, and the filter's estimates of it.
struct Journey {
  std::vector<Estimate::Mean> truth;
  std::vector<Estimate> online;
  std::vector<Step> steps;  // to each of them
};

Estimate::Mean drawn_state(const Estimate::Covariance& covariance, test::Random& random) {
  Estimate::Mean normal;
  for (int i = 0; i < Estimate::kSize; ++i) normal[i] = random.normal();
  const auto root = covariance.ldlt();
  return root.transpositionsP().transpose() *
         (root.matrixL() * root.vectorD().cwiseMax(0).cwiseSqrt().cwiseProduct(normal)).eval();
}

Measurement measured(const Estimate::Mean& truth, std::size_t sensor, test::Random& random) {
  const Eigen::Vector2d offset = truth.segment<2>(4 + 2 * static_cast<int>(sensor));
  const Eigen::Vector2d place = truth.head<2>() + offset + kNoise * random.normal2();
  return {sensor, seen_at(place.x(), place.y(), kNoise)};
}

Journey journey_of(const std::vector<double>& deviations, std::size_t images, test::Random& random) {
  Journey journey;
  const SharedErrors errors = errors_of(deviations);
  Estimate::Mean truth =
      drawn_state(first_estimate({0, seen_at(0, 0, kNoise)}, errors, kRobotSpeed).covariance, random);
  truth.head<2>().setZero();
  Estimate estimate = first_estimate(measured(truth, 0, random), errors, kRobotSpeed);
  Step step;
  for (std::size_t i = 0; i < images; ++i) {
    if (i > 0) {
      step = robot_step(errors, kWalkInterval);
      truth = predicted({truth, Estimate::Covariance::Zero()}, step).mean +
              drawn_state(predicted({truth, Estimate::Covariance::Zero()}, step).covariance, random);
      estimate = predicted(estimate, step);
      correct(estimate, measured(truth, i % deviations.size(), random), 1e9);
    }
    journey.truth.push_back(truth);
    journey.online.push_back(estimate);
    journey.steps.push_back(step);
  }
  return journey;
}

std::vector<Estimate> smoothed_journey(const Journey& journey) {
  std::vector<Estimate> all = journey.online;
  for (std::size_t i = all.size() - 1; i-- > 0;) all[i] = smoothed(journey.online[i], journey.steps[i + 1], all[i + 1]);
  return all;
}

/// Returns the normalised squared error of place and velocity: 4 in the mean if the covariance is honest.
double normalised(const Estimate& estimate, const Estimate::Mean& truth) {
  const Eigen::Vector4d error = (estimate.mean - truth).head<4>();
  return error.dot(estimate.covariance.topLeftCorner<4, 4>().inverse() * error);
}

TEST(Estimate, HasHonestCovariancesOnlineAndSmoothed) {
  constexpr int runs = 80;
  constexpr std::size_t images = 12;
  test::Random random(11);
  for (const std::vector<double>& deviations : {std::vector<double>{0.}, {0.03}, {0.02, 0.05}}) {
    double online = 0, after = 0;
    for (int i = 0; i < runs; ++i) {
      const Journey journey = journey_of(deviations, images, random);
      online += normalised(journey.online.back(), journey.truth.back()) / runs;
      after += normalised(smoothed_journey(journey)[images / 2], journey.truth[images / 2]) / runs;
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
    const Journey journey = journey_of({0.}, 20, random);
    online += (journey.online[10].velocity() - journey.truth[10].segment<2>(2)).squaredNorm();
    after += (smoothed_journey(journey)[10].velocity() - journey.truth[10].segment<2>(2)).squaredNorm();
    EXPECT_LT(smoothed_journey(journey)[10].velocity_covariance().trace(),
              journey.online[10].velocity_covariance().trace());
  }
  EXPECT_LT(after, 0.6 * online);
}

TEST(Estimate, DoesNotAverageASharedErrorAway) {
  test::Random random(13);
  const Journey journey = journey_of({0.03}, 150, random);
  EXPECT_GT(journey.online.back().position_covariance()(0, 0), 0.8 * 0.03 * 0.03);
}

TEST(Estimate, OfTwoSensorsHasTheErrorThatTheoryGives) {
  test::Random random(14);
  // two equal shared errors: half the covariance. The rest is the noise of the measurements, as if there were no shared error.
  const double noise = journey_of({0., 0.}, 90, random).online.back().position_covariance()(0, 0);
  const double one = journey_of({0.05}, 90, random).online.back().position_covariance()(0, 0) - noise;
  const double two = journey_of({0.05, 0.05}, 90, random).online.back().position_covariance()(0, 0) - noise;
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
