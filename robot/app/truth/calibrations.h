// The calibrations of a lab's sensors, in one file that the viewer's calibrations are saved to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/truth/calibration/calibration_file.h"
#include "sim/field/field.h"

namespace robot::app {

/// A sensor's place, and how well it is known.
struct PlacedSensor {
  truth::SensorPose pose;
  truth::Lens lens;
  double error_mean = 0, error_p95 = 0;  // [m] expected for robots; 0: exact
};

/// Returns the place that a calibration gives.
PlacedSensor placed_by(const truth::Calibration& calibration);

/// The field whose landmarks are clicked.
struct CalibratedField {
  sim::field::Field field;
  double ball_radius = 0.05;  // [m]
};

/// Calibrates the sensor of an image by clicks in it, as truth::calibrate(). The lens of an ordinary camera is fitted too.
Result<truth::Calibration> calibrate_by(const std::vector<truth::Click>& clicks, const truth::DepthFrame& image,
                                        const CalibratedField& on);

/// Any thread.
class Calibrations {
 public:
  /// Reads the file, if it exists. The rules give the field: "spl2025:5". An empty path: nothing can be saved.
  static Result<Calibrations> open(std::filesystem::path path, const std::string& rules);

  /// Returns the saved calibration of the sensor with this address, or nothing if the file has none. Returns an Error for one
  /// of another sensor, whose intrinsics differ, and for one of another field.
  Result<std::optional<truth::SensorCalibration>> find(const std::string& address,
                                                       const truth::Intrinsics& intrinsics) const;

  /// Saves a calibration in place of an older one of the sensor. Returns an Error for one that was refused, or if the file
  /// cannot be written.
  Result<void> save(const std::string& address, const truth::Intrinsics& intrinsics,
                    const truth::Calibration& calibration);

  const std::filesystem::path& path() const { return path_; }

 private:
  Calibrations(std::filesystem::path path, std::string field, truth::CalibrationFile file)
      : path_(std::move(path)), field_(std::move(field)), lock_(std::make_unique<Mutex>()), file_(std::move(file)) {}

  std::filesystem::path path_;
  std::string field_;            // the name of its rules: "spl2025"
  std::unique_ptr<Mutex> lock_;  // guards the file
  truth::CalibrationFile file_;
};

}  // namespace robot::app
