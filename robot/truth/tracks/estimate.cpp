#include "robot/truth/tracks/estimate.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace robot::truth {
namespace {

constexpr int kOffsets = 2 * static_cast<int>(kMostSensors);

using MeasuredRows = Eigen::Matrix<double, 2, Estimate::kSize>;

int row_of(std::size_t sensor) { return 4 + 2 * static_cast<int>(sensor); }

/// Returns the covariance of the measurable place (true place + offset) with the whole state.
MeasuredRows measured_rows(const Estimate& estimate, std::size_t sensor) {
  return estimate.covariance.topRows<2>() + estimate.covariance.middleRows<2>(row_of(sensor));
}

Place place_from(const Estimate& estimate, const MeasuredRows& rows, std::size_t sensor) {
  return {estimate.position() + estimate.mean.segment<2>(row_of(sensor)),
          rows.leftCols<2>() + rows.middleCols<2>(row_of(sensor))};
}

Innovation innovation_of(const Place& expected, const Place& measured) {
  Innovation result;
  result.difference = measured.position - expected.position;
  result.covariance = expected.covariance + measured.covariance;
  result.distance_squared = result.difference.dot(result.covariance.inverse() * result.difference);
  result.log_density =
      -0.5 * result.distance_squared - std::log(2 * std::numbers::pi) - 0.5 * std::log(result.covariance.determinant());
  return result;
}

void make_symmetric(Estimate::Covariance& covariance) {
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
}

/// Returns the transition times the covariance of place and velocity with the whole state.
Eigen::Matrix<double, 4, Estimate::kSize> moved_rows(const Estimate& estimate, const Step& step) {
  return step.transition * estimate.covariance.topRows<4>();
}

}  // namespace

Estimate first_estimate(const Measurement& measurement, const SharedErrors& shared, double speed_deviation) {
  Estimate estimate;
  estimate.mean.head<2>() = measurement.place.position;
  const Eigen::Matrix2d& own = shared[measurement.sensor];
  estimate.covariance.topLeftCorner<2, 2>() = measurement.place.covariance + own;
  estimate.covariance.block<2, 2>(2, 2) = speed_deviation * speed_deviation * Eigen::Matrix2d::Identity();
  for (std::size_t sensor = 0; sensor < kMostSensors; ++sensor)
    estimate.covariance.block<2, 2>(row_of(sensor), row_of(sensor)) = shared[sensor];

  // place = measurement - offset - noise
  estimate.covariance.block<2, 2>(0, row_of(measurement.sensor)) = -own;
  estimate.covariance.block<2, 2>(row_of(measurement.sensor), 0) = -own;
  return estimate;
}

Estimate predicted(const Estimate& estimate, const Step& step) {
  Estimate next;
  next.mean.head<4>() = step.transition * estimate.mean.head<4>() + step.shift;
  next.mean.tail<kOffsets>() = step.offsets_kept * estimate.mean.tail<kOffsets>();

  const Eigen::Matrix<double, 4, Estimate::kSize> rows = moved_rows(estimate, step);
  const Eigen::Matrix<double, 4, kOffsets> crossed = step.offsets_kept * rows.rightCols<kOffsets>();
  next.covariance.topLeftCorner<4, 4>() = rows.leftCols<4>() * step.transition.transpose() + step.noise;
  next.covariance.topRightCorner<4, kOffsets>() = crossed;
  next.covariance.bottomLeftCorner<kOffsets, 4>() = crossed.transpose();
  next.covariance.bottomRightCorner<kOffsets, kOffsets>() =
      step.offsets_kept * step.offsets_kept * estimate.covariance.bottomRightCorner<kOffsets, kOffsets>();
  for (std::size_t sensor = 0; sensor < kMostSensors; ++sensor)
    next.covariance.block<2, 2>(row_of(sensor), row_of(sensor)) += step.offset_noise[sensor];
  return next;
}

Place expected_place(const Estimate& estimate, std::size_t sensor) {
  return place_from(estimate, measured_rows(estimate, sensor), sensor);
}

Innovation innovation(const Estimate& estimate, const Measurement& measurement) {
  return innovation_of(expected_place(estimate, measurement.sensor), measurement.place);
}

void correct(Estimate& estimate, const Measurement& measurement, double gate) {
  const MeasuredRows rows = measured_rows(estimate, measurement.sensor);
  const Innovation found = innovation_of(place_from(estimate, rows, measurement.sensor), measurement.place);
  const double inflation = std::max(1., found.distance_squared / gate);
  const Eigen::Matrix<double, Estimate::kSize, 2> gain = rows.transpose() * (inflation * found.covariance).inverse();

  estimate.mean += gain * found.difference;
  estimate.covariance -= gain * rows;
  make_symmetric(estimate.covariance);
}

Estimate smoothed(const Estimate& filtered, const Step& step, const Estimate& smoothed_after) {
  const Estimate before = predicted(filtered, step);

  // covariance of the state after the step with the one before it; an exact sensor's offset has no variance at all
  Estimate::Covariance crossed;
  crossed.topRows<4>() = moved_rows(filtered, step);
  crossed.bottomRows<kOffsets>() = step.offsets_kept * filtered.covariance.bottomRows<kOffsets>();
  const Estimate::Covariance gain = before.covariance.ldlt().solve(crossed).transpose();

  Estimate result;
  result.mean = filtered.mean + gain * (smoothed_after.mean - before.mean);
  result.covariance = filtered.covariance + gain * (smoothed_after.covariance - before.covariance) * gain.transpose();
  make_symmetric(result.covariance);
  return result;
}

}  // namespace robot::truth
