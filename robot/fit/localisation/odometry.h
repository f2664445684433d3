// How the robots' odometry drifts: the believed path beside the true one.
#pragma once

#include "robot/fit/evidence.h"
#include "robot/fit/localisation/drift.h"
#include "robot/fit/localisation/odometry_fit.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Fits the errors of odometry to `odometry` and the robots' true places and headings: localisation.translation_noise,
/// rotation_noise, rotation_per_metre and bias. The intervals cover the luck of walks; blocks of twenty windows are resampled.
/// The first three need forty windows in which the robot walks. The bias needs the scales of three robots.
Report fit_odometry(const Evidence& evidence, const sim::Models& base);

/// The same for a drift that was read already.
Report odometry_report(const Drift& drift, const sim::Models& base);

/// Returns the intervals of translation_noise, rotation_noise and rotation_per_metre.
std::vector<RootInterval> noise_intervals(const Drift& drift, const OdometryFit& fit);

/// Reads the drift of all robots. `problems` receives the reason if nobody can be judged.
Drift read_drift(const Evidence& evidence, std::vector<std::string>& problems);

}  // namespace robot::fit
