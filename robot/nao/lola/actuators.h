// What LoLA is told every 12 ms, and the frame that tells it.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "robot/nao/lola/joints.h"

namespace robot::nao {

/// A light of three colours, each 0 .. 1.
using Colour = std::array<float, 3>;

/// All lights of a robot; those of one eye shine alike.
struct Lights {
  Colour chest{}, l_foot{}, r_foot{}, l_eye{}, r_eye{};
  std::array<float, 10> l_ear{}, r_ear{};  // [0..1]
  std::array<float, 12> skull{};           // [0..1]
};

struct Actuators {
  PerJoint<float> position{};   // [rad]; hands 0 closed .. 1 open
  PerJoint<float> stiffness{};  // [0..1]
  Lights lights;
  bool sonar = true;  // both sides listen
};

/// One frame that is made once; from then on only its numbers are written anew, in place.
class ActuatorFrame {
 public:
  static constexpr std::size_t kBytes = 786;

  ActuatorFrame();

  /// The bytes that tell `actuators`; good until the next call. Allocates nothing.
  std::string_view compose(const Actuators& actuators);

 private:
  void begin(std::string_view key, std::size_t numbers);
  void put(float value);

  std::string bytes_;
  std::vector<std::size_t> fields_;  // where the first number of each field is, in the order they are composed
  std::size_t at_ = 0;               // where the next number goes
};

}  // namespace robot::nao
