// The landmarks of a field, which a person clicks in a picture to calibrate a sensor.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "sim/field/field.h"

namespace robot::truth {

struct Landmark {
  std::string name;                                    // "corner +x +y": the signs are those of its coordinates
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m, field] the middle of crossing lines, or of a post's foot
  double deviation = 0;  // [m] of a careful click from the position: a post hides the middle of its foot
};

/// Returns all landmarks of the field: crossings of lines, marks, and the feet of the posts. All names differ.
std::vector<Landmark> landmarks_of(const sim::field::Field& field);

/// Returns the landmark with this name, or nullptr.
const Landmark* find_landmark(const std::vector<Landmark>& landmarks, std::string_view name);

}  // namespace robot::truth
