// One sensor of the calibration file as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "robot/truth/calibration/calibration_file.h"
#include "robot/truth/calibration/json_reader.h"

namespace robot::truth {

nlohmann::json sensor_to_json(const SensorCalibration& sensor);

/// Returns the sensor. Problems are recorded by the reader.
SensorCalibration read_sensor(JsonReader& reader, const nlohmann::json& entry);

}  // namespace robot::truth
