// The file with the calibrations of a lab's sensors (lab.json), and the file of clicks.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/calibration/calibrate.h"

namespace robot::truth {

/// The calibration of one sensor, as the file keeps it.
struct SensorCalibration {
  std::string address;    // of the sensor, as on the command line: "freenect:0"
  std::string field;      // the name of the field's rules: "spl2012"
  Intrinsics intrinsics;  // of the sensor's images; `pose` may have a fitted focal length
  SensorPose pose;
  Lens lens;
  std::vector<ClickResidual> clicks;
  double error_mean = 0, error_p95 = 0;  // [m] expected for robots
};

/// All calibrations of a lab. Their addresses differ.
struct CalibrationFile {
  std::vector<SensorCalibration> sensors;
};

/// Puts a calibration into the file, in place of an older one of the same address. Returns an Error for a refused one.
Result<void> put_calibration(CalibrationFile& file, const std::string& address, const std::string& field,
                             const Intrinsics& intrinsics, const Calibration& calibration);

/// Returns the calibration of this sensor. Returns an Error if the file has none for its address, or one of another sensor:
/// with other intrinsics.
Result<SensorCalibration> calibration_for(const CalibrationFile& file, std::string_view address,
                                          const Intrinsics& intrinsics);

/// Returns the pose of this sensor, as calibration_for().
Result<SensorPose> pose_for(const CalibrationFile& file, std::string_view address, const Intrinsics& intrinsics);

/// Returns the text that parse_calibrations() reads back without loss.
std::string print_calibrations(const CalibrationFile& file);
Result<CalibrationFile> parse_calibrations(std::string_view text);

/// Reads a file of at most 4 MB. Its name opens the sentence of an Error.
Result<CalibrationFile> read_calibrations(const std::filesystem::path& path);
/// Replaces the file at once: a reader sees the old one or the new one.
Result<void> write_calibrations(const std::filesystem::path& path, const CalibrationFile& file);

/// Reads a file of clicks, of at most 1 MB: the message that parse_clicks() reads.
Result<std::vector<Click>> read_clicks(const std::filesystem::path& path);
Result<void> write_clicks(const std::filesystem::path& path, const std::vector<Click>& clicks);

}  // namespace robot::truth
