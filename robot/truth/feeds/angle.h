// Angles in one turn.
#pragma once

#include <cmath>
#include <numbers>

namespace robot::truth {

/// Returns the same direction in (-π, π] [rad].
inline double in_one_turn(double angle) {
  const double turned = std::remainder(angle, 2 * std::numbers::pi);
  return turned <= -std::numbers::pi ? std::numbers::pi : turned;
}

}  // namespace robot::truth
