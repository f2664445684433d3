// How well the robots know where they are: the believed pose beside the true one.
#pragma once

#include "robot/fit/evidence.h"
#include "robot/fit/localisation/mark_fit.h"
#include "robot/fit/localisation/mark_report.h"
#include "robot/fit/localisation/pose_errors.h"
#include "robot/fit/report.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Fits figures of sim/perception/model.h to `pose` beside the truth. Eight entrances or more show start_deviation and that of the
/// heading, eight falls fall_deviation. Ten minutes of unsure robots show flips_per_minute, three flips that ended flip_duration.
/// With mark_deviation and that of the heading, the simulator's own localisation makes the recorded errors on the same walks. The
/// intervals cover the luck of events and of half minutes. The field is that of /sim/state, else that of the league. Errors of
/// the pose are results.
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
