#include "robot/truth/calibration/calibration_file.h"

#include <algorithm>
#include <set>

#include "robot/core/files.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "robot/truth/calibration/calibration_json.h"
#include "robot/truth/calibration/sensor_json.h"

namespace robot::truth {
namespace {

constexpr std::size_t kMostFileBytes = 4 << 20, kMostClickBytes = 1 << 20;

std::string printed(const nlohmann::json& json) {
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string addresses_of(const CalibrationFile& file) {
  std::vector<std::string> addresses;
  for (const SensorCalibration& sensor : file.sensors) addresses.push_back("'" + sensor.address + "'");
  return addresses.empty() ? "no sensor" : joined(addresses, ", ");
}

std::string described(const Intrinsics& it) {
  return formatted("%d x %d px with focal length %.2f, %.2f and centre %.2f, %.2f px", it.width, it.height, it.focal_x,
                   it.focal_y, it.centre_x, it.centre_y);
}

}  // namespace

Result<void> put_calibration(CalibrationFile& file, const std::string& address, const std::string& field,
                             const Intrinsics& intrinsics, const Calibration& calibration) {
  if (!calibration.refused.empty())
    return Error{formatted("calibration of '%s': refused, since %s", address.c_str(), calibration.refused.c_str())};
  SensorCalibration sensor{.address = address,
                           .field = field,
                           .intrinsics = intrinsics,
                           .pose = calibration.pose,
                           .lens = calibration.lens,
                           .clicks = calibration.residuals,
                           .error_mean = calibration.robots.mean,
                           .error_p95 = calibration.robots.p95};
  const auto older = std::find_if(file.sensors.begin(), file.sensors.end(),
                                  [&](const SensorCalibration& it) { return it.address == address; });
  if (older == file.sensors.end())
    file.sensors.push_back(std::move(sensor));
  else
    *older = std::move(sensor);
  return {};
}

Result<SensorCalibration> calibration_for(const CalibrationFile& file, std::string_view address,
                                          const Intrinsics& intrinsics) {
  const std::string name = printable(address, 100);
  const auto found = std::find_if(file.sensors.begin(), file.sensors.end(),
                                  [&](const SensorCalibration& sensor) { return sensor.address == address; });
  if (found == file.sensors.end())
    return Error{formatted("calibration: expected one of '%s', got %s", name.c_str(), addresses_of(file).c_str())};
  if (!(found->intrinsics == intrinsics))
    return Error{formatted("calibration of '%s': expected that of a sensor of %s, got one of %s", name.c_str(),
                           described(intrinsics).c_str(), described(found->intrinsics).c_str())};
  return *found;
}

Result<SensorPose> pose_for(const CalibrationFile& file, std::string_view address, const Intrinsics& intrinsics) {
  const auto calibration = calibration_for(file, address, intrinsics);
  if (!calibration) return calibration.failure();
  return calibration->pose;
}

std::string print_calibrations(const CalibrationFile& file) {
  auto sensors = nlohmann::json::array();
  for (const SensorCalibration& sensor : file.sensors) sensors.push_back(sensor_to_json(sensor));
  return printed({{"sensors", std::move(sensors)}});
}

Result<CalibrationFile> parse_calibrations(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.failure("calibrations");
  constexpr std::size_t kMostSensors = 100;
  JsonReader reader("calibrations");
  CalibrationFile file;
  std::set<std::string> addresses;
  for (const auto& entry : reader.list(*json, "sensors", kMostSensors)) {
    file.sensors.push_back(read_sensor(reader, entry));
    const std::string& address = file.sensors.back().address;
    if (!addresses.insert(address).second)
      reader.refuse(formatted("the address '%s' appears twice", printable(address, 100).c_str()));
  }
  if (!reader.good()) return reader.error();
  return file;
}

Result<CalibrationFile> read_calibrations(const std::filesystem::path& path) {
  const auto text = read_file(path, kMostFileBytes);
  if (!text) return text.failure();
  auto file = parse_calibrations(*text);
  if (!file) return file.failure(path.string());
  return file;
}

Result<void> write_calibrations(const std::filesystem::path& path, const CalibrationFile& file) {
  return replace_file(path, print_calibrations(file));
}

Result<std::vector<Click>> read_clicks(const std::filesystem::path& path) {
  const auto text = read_file(path, kMostClickBytes);
  if (!text) return text.failure();
  auto clicks = parse_clicks(*text);
  if (!clicks) return clicks.failure(path.string());
  return clicks;
}

Result<void> write_clicks(const std::filesystem::path& path, const std::vector<Click>& clicks) {
  return replace_file(path, printed(to_json(clicks)));
}

}  // namespace robot::truth
