// The check of clicks before a calibration.
#pragma once

#include <vector>

#include "robot/truth/calibration/calibrate.h"

namespace robot::truth {

/// The fewest landmarks of a calibration. Three would fit several poses.
inline constexpr std::size_t kFewestLandmarks = 4;

/// Returns an Error if the clicks cannot give any calibration: see calibrate().
Result<void> check_clicks(const std::vector<Landmark>& landmarks, const std::vector<Click>& clicks,
                          const Projection& camera, const CalibrationOptions& options);

}  // namespace robot::truth
