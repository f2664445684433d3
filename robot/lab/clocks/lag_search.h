// The lag between two clocks, found from the distance of the ball that both sides measured.
#pragma once

#include "robot/core/result.h"
#include "robot/lab/clocks/shared_distance.h"

namespace robot::lab {

/// The lags to search: from `middle - reach` to `middle + reach`, at most kLongestReach on each side.
struct LagRange {
  double middle = 0, reach = 60;  // [s]
};

inline constexpr double kLongestReach = 300;  // [s] more would take long and find accidents

/// The lag of a robot's clock.
struct Lag {
  double seconds = 0;    // > 0: the robot's clock is ahead
  double deviation = 0;  // [s] one standard deviation
};

/// A lag with a larger standard deviation is refused [s]: a ball of 1.5 m/s rolls 3 cm in that time.
inline constexpr double kLargestDeviation = 0.02;

/// A lag that is known to a tenth of a second or two.
struct CoarseLag {
  double seconds = 0;
  double gain = 0;  // log likelihood by which the truth explains the distances better than a constant one does
};

/// Finds the lag at which the truth explains the robot's distances best, in coarse steps. Returns an Error if too few values
/// have a truth, or if other lags fit as well, as they do while all things move at a constant speed.
Result<CoarseLag> find_coarse_lag(const SharedDistance& distance, const LagRange& range);

/// Refines a coarse lag [s]. Its deviation is that of a bootstrap over blocks of 2 s. Returns an Error if that exceeds
/// `largest` [s].
Result<Lag> refined_lag(const SharedDistance& distance, double coarse, double largest = kLargestDeviation);

}  // namespace robot::lab
