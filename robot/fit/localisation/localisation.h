// How well the robots know where they are: the believed pose beside the true one.
#pragma once

#include "robot/fit/evidence.h"
#include "robot/fit/localisation/pose_errors.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Fits the events that spoil the pose: localisation.start_deviation and fall_deviation with their headings, by eight entrances and
/// eight falls or more; flips_per_minute by the minutes in which a robot was unsure, at least ten; flip_duration by three flips
/// that ended. The intervals cover the luck of events. Errors of the pose are results.
Report fit_localisation(const Evidence& evidence, const sim::Models& base);

/// The same for errors that were read already.
Report localisation_report(const PoseErrors& poses, const sim::Models& base);

}  // namespace robot::fit
