// The reasons to refuse a finished calibration.
#pragma once

#include <string>
#include <vector>

#include "robot/truth/calibration/calibrate.h"
#include "robot/truth/calibration/fit.h"

namespace robot::truth {

/// Returns the reason to refuse a calibration with the help for it, or an empty text. `sightings` are those of the clicks, in
/// their order.
std::string refusal_of(const Calibration& calibration, const Fit& fit, const std::vector<Landmark>& landmarks,
                       const std::vector<Sighting>& sightings, const CalibrationOptions& options);

}  // namespace robot::truth
