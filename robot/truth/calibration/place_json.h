// The place of a sensor as JSON: {"rotation": [9 numbers row by row], "x", "y", "z"} [m, field].
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>

#include "robot/truth/calibration/json_reader.h"

namespace robot::truth {

nlohmann::json place_to_json(const Eigen::Isometry3d& field_from_sensor);

/// Returns the place. Refuses numbers that are no rotation.
Eigen::Isometry3d read_place(JsonReader& reader, const nlohmann::json& place);

}  // namespace robot::truth
