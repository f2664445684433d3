// The luck of walking steps: how much they differ from each other.
#pragma once

#include <cstddef>
#include <optional>

#include "robot/fit/walking/walk_fit.h"

namespace robot::fit {

/// A standard deviation of steps.
struct StepLuck {
  double value = 0, low = 0, high = 0;  // and its interval that covers 95 %
  double deviation = 0;                 // of the value
  std::size_t seconds = 0;              // of steady walking
  std::size_t drives = 0;
};

struct WalkLuck {
  std::optional<StepLuck> speed;  // as share of the speed; nothing with too little steady walking
  std::optional<StepLuck> turn;   // [rad/s]
  double seconds = 0;             // of steady walking, also with too little
};

inline constexpr std::size_t kFewestLucky = 20;  // [s] of steady walking

/// Measures the luck by what the fitted walk misses over 5/3 s less what it misses over 2/3 s: errors of the truth are in both.
/// Only walks with a steady gait count, since others start or stop with a phase of the steps that is not known.
WalkLuck measure_luck(const WalkProblem& problem, const WalkFit& fit);

}  // namespace robot::fit
