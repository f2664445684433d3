#include "robot/app/truth/calibrations.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace robot::app {

PlacedSensor placed_by(const truth::Calibration& calibration) {
  return {.pose = calibration.pose,
          .lens = calibration.lens,
          .error_mean = calibration.robots.mean,
          .error_p95 = calibration.robots.p95};
}

Result<truth::Calibration> calibrate_by(const std::vector<truth::Click>& clicks, const truth::DepthFrame& image,
                                        const CalibratedField& on) {
  const bool ordinary = image.depth.empty();
  return truth::calibrate(truth::landmarks_of(on.field), clicks, image,
                          {.ball_radius = on.ball_radius, .focal_free = ordinary, .k1_free = ordinary});
}

Result<Calibrations> Calibrations::open(std::filesystem::path path, const std::string& rules) {
  truth::CalibrationFile file;
  std::error_code none;
  if (!path.empty() && std::filesystem::exists(path, none)) {
    auto read = truth::read_calibrations(path);
    if (!read) return read.failure();
    file = std::move(*read);
  }
  return Calibrations(std::move(path), rules.substr(0, rules.find_first_of(":,")), std::move(file));
}

Result<std::optional<truth::SensorCalibration>> Calibrations::find(const std::string& address,
                                                                   const truth::Intrinsics& intrinsics) const {
  const std::lock_guard guard(*lock_);
  const bool known = std::any_of(file_.sensors.begin(), file_.sensors.end(),
                                 [&](const truth::SensorCalibration& one) { return one.address == address; });
  if (!known) return std::optional<truth::SensorCalibration>();
  auto found = truth::calibration_for(file_, address, intrinsics);
  if (!found) return found.failure(path_.string());
  if (found->field != field_)
    return Error{path_.string() + ": " + address + " was calibrated on the field of '" + found->field +
                 "', expected that of '" + field_ + "'; calibrate it again, or choose --rules " + found->field};
  return std::optional(std::move(*found));
}

Result<void> Calibrations::save(const std::string& address, const truth::Intrinsics& intrinsics,
                                const truth::Calibration& calibration) {
  if (path_.empty()) return Error{"nothing is saved: start with --calibration FILE"};
  const std::lock_guard guard(*lock_);
  truth::CalibrationFile changed = file_;
  if (const Result<void> put = truth::put_calibration(changed, address, field_, intrinsics, calibration); !put)
    return put.failure();
  if (const Result<void> written = truth::write_calibrations(path_, changed); !written) return written.failure();
  file_ = std::move(changed);
  return {};
}

}  // namespace robot::app
