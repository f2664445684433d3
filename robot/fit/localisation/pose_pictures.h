// Pictures of the errors of believed poses.
#pragma once

#include "robot/fit/localisation/pose_errors.h"
#include "robot/fit/report.h"
#include "sim/perception/model.h"

namespace robot::fit {

/// Adds the error over the time since a fall or entrance, the shifts by these events, and the errors beside the reported deviations.
/// The fitted circles are those of the figures in the report; `base` is drawn to compare.
void add_pose_pictures(const PoseErrors& poses, const sim::perception::Localisation& base, Report& report);

}  // namespace robot::fit
