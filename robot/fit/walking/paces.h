// The pace of the fastest of all robots, and how much robots differ, from those that were recorded.
#pragma once

#include <optional>

#include "robot/fit/math/least_squares.h"

namespace robot::fit {

/// A value and its interval that covers 95 %.
struct Likely {
  double value = 0, low = 0, high = 0;
};

struct Fastest {
  Likely log_pace;  // logarithm of the pace of the fastest possible robot, in the unit of the given ones
  Likely spread;    // [0..0.9] the share by which the slowest robot is slower
};

inline constexpr std::size_t kFewestPaces = 4;  // robots that show a spread

/// Returns the posterior of a pace that is uniform in [1 - spread, 1] of the fastest robot's (sim/motion/model.h), given the
/// logarithms of some robots' paces with their deviations. At least one. Without `spread` it is found, too: at least two.
Fastest fastest_of(const Vector& log_paces, const Vector& deviations, std::optional<double> spread);

}  // namespace robot::fit
