// The walk of robots: achieved against commanded motion.
#pragma once

#include "robot/fit/evidence.h"
#include "robot/fit/report.h"
#include "robot/fit/walking/drives.h"
#include "robot/fit/walking/step_luck.h"
#include "robot/fit/walking/walk_fit.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Fits `walk.forward`, `backward`, `sideward`, `turn_rate`, `turn_cost`, `acceleration`, `turn_acceleration`, `start_delay`,
/// `stop_delay`, `spread`, `speed_noise` and `turn_noise` to the commands of robots (`motion_command`) and their true paths with
/// headings. The rest of the walk is that of `base`.
///
/// The fit replays the commands in the simulator's mean walk and compares the motion over thirds of a second. It leaves out
/// kicks, falls, penalties, and times with another robot within half a metre. Each drive of at most 20 s shares its luck. The
/// intervals come from the scatter between drives, from the error of each robot's clock and from the luck of the steps.
///
/// The speeds are those of the fastest robot. With four robots or more `walk.spread` is fitted, too; with fewer, the spread of
/// `base` gives the fastest robot, and the interval is as wide as that leaves it. `walk.stop_delay` needs `motion_status`: its
/// `stopping` and `standing`, after walks that the brakes end sooner.
///
/// A figure whose motion the recordings do not show is kept, with the reason.
Report fit_walking(const Evidence& evidence, const sim::Models& base);

/// The same from drives.
Report fit_walking(const Drives& drives, const sim::Models& base);

/// A fit with all that its pictures and results show.
struct FittedWalk {
  WalkProblem problem;
  WalkFit fit;
  WalkLuck luck;
};

/// Returns the fit in three rounds: the luck of the steps changes the mean gait, and the mean gait the luck. Two robots' drives at
/// least, or one robot's, must be there.
FittedWalk fitted_walk(const Drives& drives, const sim::Models& base);

/// Adds the pictures: achieved over commanded speed, turn rate, and the first second and a half of starts.
void add_walk_pictures(const FittedWalk& fitted, const sim::Models& base, Report& report);

/// Adds the errors after one second on drives held out, and the table of all seconds.
void add_walk_results(const FittedWalk& fitted, const Drives& drives, const sim::Models& base, Report& report);

}  // namespace robot::fit
