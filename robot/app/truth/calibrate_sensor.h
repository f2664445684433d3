// foresight-lab calibrate: the place of one sensor by a file of clicks, without a viewer.
#pragma once

#include <filesystem>
#include <string>

#include "robot/app/truth/watch_truth.h"
#include "robot/core/result.h"
#include "robot/truth/calibration/calibrate.h"

namespace robot::app {

/// Calibrates the sensor of the only source by the clicks of a file, in its first image. Saves a good calibration in
/// `options.calibration`, unless that is empty. Waits up to ten seconds for a live sensor. Returns an Error if there is no
/// calibration; a computed one that must not be used has its reason in `refused` and is not saved.
Result<truth::Calibration> calibrate_sensor(const TruthOptions& options, const std::filesystem::path& clicks);

/// Formats a calibration for a terminal: the residual of each landmark, the check by landmarks left out, expected errors.
std::string to_text(const truth::Calibration& calibration);

}  // namespace robot::app
