// Actuator values for LoLA, sent every 12 ms, and their frame.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "robot/nao/lola/joints.h"

namespace robot::nao {

/// The colour of a light, each part 0 .. 1.
using Colour = std::array<float, 3>;

/// All lights of a robot. All lights of one eye have the same colour.
struct Lights {
  Colour chest{}, l_foot{}, r_foot{}, l_eye{}, r_eye{};
  std::array<float, 10> l_ear{}, r_ear{};  // [0..1]
  std::array<float, 12> skull{};           // [0..1]
};

struct Actuators {
  PerJoint<float> position{};   // [rad]; hands 0 closed .. 1 open
  PerJoint<float> stiffness{};  // [0..1]
  Lights lights;
  bool sonar = true;  // turns both sonars on
};

/// A frame that is laid out once. Later calls only overwrite its numbers in place.
class ActuatorFrame {
 public:
  static constexpr std::size_t kBytes = 786;

  ActuatorFrame();

  /// Returns the frame for `actuators`, valid until the next call. Allocates nothing.
  std::string_view compose(const Actuators& actuators);

 private:
  void begin(std::string_view key, std::size_t numbers);
  void put(float value);

  std::string bytes_;
  std::vector<std::size_t> fields_;  // offset of each field's first number, in the order of compose()
  std::size_t at_ = 0;               // offset of the next number
};

}  // namespace robot::nao
