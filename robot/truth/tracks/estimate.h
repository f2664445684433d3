// The belief about one thing: a Gaussian of its place, its velocity and the offsets of the sensors.
#pragma once

#include <Eigen/Core>

#include "robot/truth/tracks/shared_error.h"

namespace robot::truth {

/// Place and velocity of a thing, and for each sensor the offset by which it misplaces the thing.
///
/// The offsets come from the errors of the sensors' poses. They are part of the state, so a shared error never averages
/// away, and two sensors that disagree do not shake the track. Adding the shared covariance to each measurement instead
/// would make the result too certain within a second.
struct Estimate {
  static constexpr int kSize = 4 + 2 * static_cast<int>(kMostSensors);
  using Mean = Eigen::Matrix<double, kSize, 1>;
  using Covariance = Eigen::Matrix<double, kSize, kSize>;

  Mean mean = Mean::Zero();                    // x, y [m, field], their velocities [m/s], x and y of each offset [m]
  Covariance covariance = Covariance::Zero();  // likewise

  Eigen::Vector2d position() const { return mean.head<2>(); }
  Eigen::Vector2d velocity() const { return mean.segment<2>(2); }
  Eigen::Matrix2d position_covariance() const { return covariance.topLeftCorner<2, 2>(); }
  Eigen::Matrix2d velocity_covariance() const { return covariance.block<2, 2>(2, 2); }
};

/// A measured place.
struct Measurement {
  std::size_t sensor = 0;
  Place place;
};

/// The change of an estimate over an interval.
struct Step {
  Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
  Eigen::Vector4d shift = Eigen::Vector4d::Zero();
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  double offsets_kept = 1;                  // factor
  SharedErrors offset_noise = no_errors();  // [m²]
};

/// The place where a sensor is expected to find the thing, with the covariance of that expectation.
Place expected_place(const Estimate& estimate, std::size_t sensor);

/// The difference of a measurement from an estimate.
struct Innovation {
  Eigen::Vector2d difference;  // [m]
  Eigen::Matrix2d covariance;  // [m²]
  double distance_squared;     // Mahalanobis
  double log_density;          // of the measurement [1/m²]
};

/// Returns the estimate of a thing that was seen for the first time, with a velocity of 0 ± `speed_deviation` [m/s].
Estimate first_estimate(const Measurement& measurement, const SharedErrors& shared, double speed_deviation);

Estimate predicted(const Estimate& estimate, const Step& step);
Innovation innovation(const Estimate& estimate, const Measurement& measurement);

/// Takes the measurement into the estimate. A measurement farther away than `gate` [Mahalanobis, squared] gets as much more
/// noise as it needs to be at the gate.
void correct(Estimate& estimate, const Measurement& measurement, double gate);

/// Returns `filtered` improved by the smoothed estimate after the step (Rauch, Tung, Striebel 1965).
Estimate smoothed(const Estimate& filtered, const Step& step, const Estimate& smoothed_after);

}  // namespace robot::truth
