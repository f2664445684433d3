// Whether a robot sees the ball that is in its view.
#pragma once

#include "robot/fit/evidence.h"
#include "robot/fit/report.h"
#include "robot/fit/visibility/looks.h"
#include "robot/fit/visibility/sights.h"
#include "sim/match/params.h"

namespace robot::fit {

/// Fits from `vision`, `camera_top_matrix`, `camera_bottom_matrix` and the truth whether a ball in view is seen.
///
/// `ball_detection.near`, `.far`, `.near_range` and seldom `.far_range` are those of the simulator, by the balls that no robot hides.
/// The weights `visibility.…` of a logistic model are only reported. Its features are distance, bearing from the optical axis, their
/// squares, speed of the head and hiding. Intervals cover the luck of whole passes.
/// The truth needs headings. `base` has the view's noise, the sizes, and the detection to compare with.
Report fit_visibility(const Evidence& evidence, const sim::Models& base);
Report fit_visibility(const Looks& looks, const sim::Models& base);

/// As fit_visibility() for images that are read already.
Report visibility_of(const Sights& sights, const sim::Models& base);

}  // namespace robot::fit
