// The click that would help a calibration most.
#pragma once

#include <string>
#include <vector>

#include "robot/truth/calibration/calibrate.h"
#include "robot/truth/calibration/fit.h"

namespace robot::truth {

/// Returns "left half of the picture" or "right half of the picture" for a pixel.
const char* half_of(double x, const Projection& camera);

/// Returns the advice to click one more landmark of the picture: the one that makes the errors on the field least.
std::string advice(const Fit& fit, const std::vector<Landmark>& landmarks, const std::vector<std::string>& clicked,
                   const CalibrationOptions& options);

}  // namespace robot::truth
