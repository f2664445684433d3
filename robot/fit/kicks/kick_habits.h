// Figures of a kind of kick beside its distribution: its duration, its misses, and the direction by each foot.
#pragma once

#include <vector>

#include "robot/fit/figure.h"
#include "robot/fit/kicks/kicks.h"

namespace robot::fit {

/// Returns
///   kicks.….duration         [s] median time from its begin to its end, if the motion status shows it for 5 kicks or more
///   kicks.….missed           share of kicks in place whose ball did not move (Wilson 1927), only reported
///   kicks.….direction_left   [rad, robot] mean direction of full and partial hits with this foot, mirrored for the right one; only
///   kicks.….direction_right  reported, from 8 kicks on
/// The intervals cover 95 %. That of the duration reaches at least the time between two messages to either side.
std::vector<Figure> habits_of(const KickFit& fit);

}  // namespace robot::fit
