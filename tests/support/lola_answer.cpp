#include "tests/support/lola_answer.h"

#include "robot/core/json_library.h"

namespace tests {

using namespace robot::nao;
using nlohmann::json;

std::optional<Actuators> read_answer(const std::string& bytes) {
  const json answer = json::from_msgpack(bytes, true, false);
  if (!answer.is_object()) return std::nullopt;
  Actuators actuators;
  try {
    actuators.position = answer.at("Position").get<PerJoint<float>>();
    actuators.stiffness = answer.at("Stiffness").get<PerJoint<float>>();
    actuators.lights.chest = answer.at("Chest").get<Colour>();
    for (std::size_t i = 0; i < 3; ++i) actuators.lights.l_eye[i] = answer.at("LEye").at(8 * i).get<float>();
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return actuators;
}

}  // namespace tests
