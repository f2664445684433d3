// The inputs of the walk.
#pragma once

#include <array>

#include "robot/nao/walk/legs.h"

namespace robot::nao::walk {

/// One frame of sensors. Frame: torso.
struct Sensors {
  std::array<double, 3> rate{};                 // [rad/s] of the torso, about x, y and z
  double roll = 0, pitch = 0;                   // [rad] of the torso: roll > 0 to the right, pitch > 0 forward
  std::array<std::array<double, 4>, 2> load{};  // [kg] by Side: front left, front right, rear left, rear right
  Legs joints{};                                // [rad] measured

  double load_of(Side side) const { return load[side][0] + load[side][1] + load[side][2] + load[side][3]; }
};

/// A kick with a step of the walk.
enum class KickStep { none, forward, side, turn };

/// A velocity over ground, in the robot's own frame. All zero: stand.
struct Command {
  double forward = 0;  // [m/s]
  double left = 0;     // [m/s]
  double turn = 0;     // [rad/s] > 0 to the left

  /// Kicks with the next step of `foot`: forward, outwards, or by turning the toes inwards. A standing robot walks on the
  /// spot for that. One step kicks once; the command counts again in the next step of that foot.
  KickStep kick = KickStep::none;
  Side foot = Side::left;

  bool stands() const { return forward == 0 && left == 0 && turn == 0 && kick == KickStep::none; }
};

}  // namespace robot::nao::walk
