// Angles on the circle.
#pragma once

#include <cmath>
#include <numbers>

namespace robot::fit {

/// Returns the same angle in [-π, π].
inline double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace robot::fit
