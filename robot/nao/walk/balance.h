// How far the robot tips, compared with its usual course in a step.
#pragma once

#include <array>

#include "robot/nao/walk/parameters.h"
#include "robot/nao/walk/sensors.h"

namespace robot::nao::walk {

/// An error of the capture point: the point where the pendulum of the body would come to rest, minus the place where it
/// should be. [m, torso]
struct Tipping {
  double forward = 0;
  double left = 0;
};

/// The tilt of the body. A walk rocks by itself, so the error of the capture point has a usual course within each step.
/// The balance learns that course for each swing foot. Only the rest of the error is a disturbance.
class Balance {
 public:
  explicit Balance(const Parameters& parameters) : parameters_(parameters) {}

  /// Takes a frame of sensors.
  void see(const Sensors& sensors);

  /// Returns the error of the capture point.
  const Tipping& error() const { return error_; }

  /// Returns the error without its usual course at `phase` [periods since the beginning] of a step of `swing`.
  Tipping disturbance(Side swing, double phase) const;

  /// Learns the usual course from the present error.
  void learn(Side swing, double phase);

  /// Adds the feedback of tilt and rates to the legs. `supports` [0..1] is the share of each leg.
  void steady(const std::array<double, 2>& supports, Legs& legs) const;

 private:
  static constexpr int kParts = 16;  // of a step, a tenth of a period each; the last one takes the rest

  static int part_of(double phase);

  const Parameters& parameters_;
  double roll_ = 0, pitch_ = 0;            // [rad]
  double roll_rate_ = 0, pitch_rate_ = 0;  // [rad/s] smoothed
  Tipping error_;
  std::array<std::array<Tipping, kParts>, 2> usual_{};  // by Side of the swing foot
};

}  // namespace robot::nao::walk
