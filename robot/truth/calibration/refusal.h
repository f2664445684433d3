// The reasons to refuse a calibration, and the click that would help.
#pragma once

#include <string>
#include <vector>

#include "robot/truth/calibration/calibrate.h"
#include "robot/truth/calibration/fit.h"

namespace robot::truth {

/// Returns an Error if the clicks cannot give any calibration: see calibrate().
Result<void> check_clicks(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks,
                          const Camera& camera, const CalibrationOptions& options);

/// Returns the reason to refuse a finished calibration, or an empty text. `sightings` are all clicks, in their order.
std::string refusal_of(const Calibration& calibration, const Fit& fit, const std::vector<Landmark>& landmarks,
                       const std::vector<Sighting>& sightings, const CalibrationOptions& options);

}  // namespace robot::truth
