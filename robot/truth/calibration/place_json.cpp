#include "robot/truth/calibration/place_json.h"

#include <Eigen/LU>

#include "robot/core/json_library.h"

namespace robot::truth {
namespace {

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

}  // namespace

nlohmann::json place_to_json(const Eigen::Isometry3d& field_from_sensor) {
  const RowMajor3 rotation = field_from_sensor.linear();
  const auto place = field_from_sensor.translation();
  return {{"rotation", std::vector<double>(rotation.data(), rotation.data() + rotation.size())},
          {"x", place.x()},
          {"y", place.y()},
          {"z", place.z()}};
}

Eigen::Isometry3d read_place(JsonReader& reader, const nlohmann::json& place) {
  constexpr double kFarthest = 1000;  // [m]
  constexpr double kRounding = 1e-6;
  const std::vector<double> rotation = reader.numbers(place, "rotation", 9, 1 + kRounding);
  Eigen::Isometry3d field_from_sensor = Eigen::Isometry3d::Identity();
  field_from_sensor.linear() = Eigen::Map<const RowMajor3>(rotation.data());
  field_from_sensor.translation() << reader.number(place, "x", -kFarthest, kFarthest),
      reader.number(place, "y", -kFarthest, kFarthest), reader.number(place, "z", -kFarthest, kFarthest);
  const Eigen::Matrix3d linear = field_from_sensor.linear();
  if (!(linear * linear.transpose()).isIdentity(kRounding) || linear.determinant() < 0)
    reader.refuse("'rotation' must be a rotation matrix row by row");
  return field_from_sensor;
}

}  // namespace robot::truth
