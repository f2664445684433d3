// How a kick sends the ball: the distribution of its speed and direction.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/fit/kicks/tracked_kick.h"

namespace robot::fit {

/// Greatest possible range_deviation, as in sim/motion/model.h.
inline constexpr double kMostRangeDeviation = 0.6;

/// The parameters of one kind of kick, as sim/motion/model.h has them. A full hit rolls a normally distributed range. A partial
/// hit gives the ball a share of the speed, all shares equally likely, and the less it gets, the more its direction deviates.
struct KickModel {
  double speed = 1;                // [m/s] of a full hit of the mean range
  double range_deviation = 0.1;    // as share of the range
  double direction = 0;            // [rad, robot], left foot
  double direction_deviation = 0;  // [rad] of a full hit
  double partial = 0;              // [0..1] probability of a partial hit

  /// Returns the density of a kick with that speed and direction, of those that are faster than `slowest` [m/s]. `spread` is the
  /// factor on the deviation of the direction after the weakest hit.
  double density(const TrackedKick& kick, double spread, double slowest) const;
};

/// The limits of observation.
struct KickSight {
  double spread = 1;   // see KickModel::density
  double slowest = 0;  // [m/s] slower balls look as if they lay
};

/// Fits the model to some of the kicks, which may repeat, by the greatest likelihood; at least one.
KickModel fit_kick(const std::vector<TrackedKick>& kicks, const std::vector<std::size_t>& chosen,
                   const KickSight& sight);
/// The probabilities of a partial hit that the kicks do not contradict.
struct PartialInterval {
  double low = 0, high = 1;  // 95 %
};

/// Returns the interval by the profile of the likelihood: near 0 and 1 resampled kicks would all agree by chance.
PartialInterval partial_interval(const std::vector<TrackedKick>& kicks, const std::vector<std::size_t>& chosen,
                                 const KickSight& sight, const KickModel& fitted);

/// Fits as fit_kick() does, from a model that is near already.
KickModel refit_kick(const std::vector<TrackedKick>& kicks, const std::vector<std::size_t>& chosen,
                     const KickSight& sight, const KickModel& near);

/// Returns the speed [m/s] of a full hit under which the kicks are likeliest, between 0.4 and 2.5 times that of the model, to 1 %.
/// All other parameters are those of the model.
double likeliest_speed(const std::vector<TrackedKick>& kicks, const KickModel& model, const KickSight& sight);

}  // namespace robot::fit
