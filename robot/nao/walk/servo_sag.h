// The sag of the servos under the robot's weight, measured while walking.
#pragma once

#include <array>

#include "robot/nao/walk/legs.h"
#include "robot/nao/walk/parameters.h"

namespace robot::nao::walk {

/// How far the joints of each leg give way while it carries the robot. Worn servos sag so far that the hip drops on the
/// side of the swing foot, which then lands too early. Targets that are raised by the sag reach their places.
class ServoSag {
 public:
  explicit ServoSag(const Parameters& parameters) : parameters_(parameters) {}

  /// Compares the measured joints with their places in the last tick. Measures the legs that have carried the robot for a
  /// while. `weights` are the shares of both legs.
  void see(const Legs& measured, const std::array<double, 2>& weights);

  /// Adds the sag of the carrying legs to `targets`. `places` are where the joints shall be, without lead.
  /// `weights` are the shares of both legs.
  void raise(const Legs& places, const std::array<double, 2>& weights, Legs& targets);

 private:
  const Parameters& parameters_;
  Legs places_{};  // of the last tick
  Legs sag_{};     // [rad] of each leg that carries all the weight
};

}  // namespace robot::nao::walk
