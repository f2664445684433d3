// The part of a report about the marks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/localisation/drift.h"
#include "robot/fit/localisation/mark_walk.h"
#include "robot/fit/report.h"
#include "sim/field/field.h"
#include "sim/match/params.h"

namespace robot::fit {

/// The walks of robots whose odometry is known, too.
struct MarkEvidence {
  std::vector<MarkWalk> walks;
  std::vector<std::size_t> drift_of;  // index of the recording in `drift`
  Drift drift;
  std::vector<std::string> recordings;
};

/// Adds the walk of a robot.
void add_mark_walk(const WatchedMotion& motion, const std::vector<PoseError>& errors, const TruthNoise& noise,
                   MarkEvidence& evidence);

/// Adds localisation.mark_deviation and mark_deviation_heading to a report, or the reasons why they stay. The odometry's figures
/// and those of starts and falls are the ones in the report or of the drift, else those of `base`.
void add_marks(const MarkEvidence& evidence, const sim::Models& base, const sim::field::Field& field, Report& report);

}  // namespace robot::fit
