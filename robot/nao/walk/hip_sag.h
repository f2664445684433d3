// The sag of the hips under the robot's weight, measured while walking.
#pragma once

#include <array>

#include "robot/nao/walk/legs.h"
#include "robot/nao/walk/parameters.h"

namespace robot::nao::walk {

/// How far the hip of each leg gives way to the side while it carries the robot. A worn hip drops the side of the swing
/// foot, which then lands early and near: the robot hardly gets sideways. Targets raised by the sag reach their places.
class HipSag {
 public:
  /// Shares of the weight on both legs, 0 to 1.
  using Weights = std::array<double, 2>;

  explicit HipSag(const Parameters& parameters) : parameters_(parameters) {}

  /// Compares the measured joints with their places in the last tick. Learns only from a leg that carries the robot.
  void see(const Legs& measured, const Weights& weights);

  /// Adds the sag of the carrying legs to `targets`. `places` are where the joints shall be.
  void raise(const Legs& places, const Weights& weights, Legs& targets);

 private:
  const Parameters& parameters_;
  std::array<double, 2> places_{};  // [rad] of the hips in the last tick
  std::array<double, 2> sag_{};     // [rad] under all the weight
};

}  // namespace robot::nao::walk
