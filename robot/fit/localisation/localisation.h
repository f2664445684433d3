// How well the robots know where they are: the believed pose beside the true one.
#pragma once

#include "robot/fit/evidence.h"
#include "robot/fit/localisation/mark_fit.h"
#include "robot/fit/localisation/mark_report.h"
#include "robot/fit/localisation/pose_errors.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Fits the events that spoil the pose: localisation.start_deviation and fall_deviation with their headings, by eight entrances and
/// eight falls or more; flips_per_minute by the minutes in which a robot was unsure, at least ten; flip_duration by three flips
/// that ended. Fits mark_deviation and mark_deviation_heading by the simulator's own localisation on the same walks, of ten minutes
/// or more. The field is that of /sim/state, else that of the league. The intervals cover the luck of events and of half minutes. Errors of the pose are results.
Report fit_localisation(const Evidence& evidence, const sim::Models& base);

/// The poses of several robots.
struct PoseEvidence {
  PoseErrors poses;
  MarkEvidence marks;
};

/// Adds a robot.
void add_poses(const WatchedMotion& motion, PoseEvidence& evidence);

/// The same as fit_localisation() for poses that were read already.
Report localisation_report(const PoseEvidence& evidence, const sim::Models& base,
                           const sim::field::Field& field = kFieldOfTheLeague);

}  // namespace robot::fit
