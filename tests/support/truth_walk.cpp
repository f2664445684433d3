#include "tests/support/truth_walk.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "robot/truth/tracks/motion.h"

namespace test {
namespace {

using namespace robot::truth;

constexpr double kWalkNoise = 0.02;        // [m]
constexpr double kWalkInterval = 1. / 30;  // [s]

SharedErrors errors_of(const std::vector<double>& deviations) {
  SharedErrors errors = no_errors();
  for (std::size_t i = 0; i < deviations.size(); ++i)
    errors[i] = deviations[i] * deviations[i] * Eigen::Matrix2d::Identity();
  return errors;
}

/// Returns a state drawn from the estimate.
Estimate::Mean drawn_state(const Estimate& estimate, Random& random) {
  Estimate::Mean normal;
  for (int i = 0; i < Estimate::kSize; ++i) normal[i] = random.normal();
  const auto root = estimate.covariance.ldlt();
  const Estimate::Mean error = root.matrixL() * root.vectorD().cwiseMax(0).cwiseSqrt().cwiseProduct(normal);
  return estimate.mean + root.transpositionsP().transpose() * error;
}

Measurement measured(const Estimate::Mean& truth, std::size_t sensor, Random& random) {
  const Eigen::Vector2d offset = truth.segment<2>(4 + 2 * static_cast<int>(sensor));
  return {sensor,
          {truth.head<2>() + offset + kWalkNoise * random.normal2(),
           kWalkNoise * kWalkNoise * Eigen::Matrix2d::Identity()}};
}

}  // namespace

Walk walk_of(const std::vector<double>& deviations, std::size_t images, Random& random) {
  const SharedErrors errors = errors_of(deviations);
  const Measurement origin{0, {Eigen::Vector2d::Zero(), 1e-6 * Eigen::Matrix2d::Identity()}};
  Estimate::Mean truth = drawn_state(first_estimate(origin, errors, kRobotSpeed), random);
  Estimate estimate = first_estimate(measured(truth, 0, random), errors, kRobotSpeed);
  const Step step = robot_step(errors, kWalkInterval);
  Walk walk{{truth}, {estimate}, {step}};
  for (std::size_t i = 1; i < images; ++i) {
    truth = drawn_state(predicted({truth, Estimate::Covariance::Zero()}, step), random);
    estimate = predicted(estimate, step);
    correct(estimate, measured(truth, i % deviations.size(), random), 1e9);
    walk.truth.push_back(truth);
    walk.online.push_back(estimate);
    walk.steps.push_back(step);
  }
  return walk;
}

std::vector<Estimate> smoothed_walk(const Walk& walk) {
  std::vector<Estimate> all = walk.online;
  for (std::size_t i = all.size() - 1; i-- > 0;) all[i] = smoothed(walk.online[i], walk.steps[i + 1], all[i + 1]);
  return all;
}

double normalised_error(const Estimate& estimate, const Estimate::Mean& truth) {
  const Eigen::Vector4d error = (estimate.mean - truth).head<4>();
  return error.dot(estimate.covariance.topLeftCorner<4, 4>().inverse() * error);
}

}  // namespace test
