// A simple Nao body as LoLA shows it: joints that follow, a torso that falls on command, hands that touch it.
#pragma once

#include <cstdint>

#include "robot/nao/lola/actuators.h"
#include "robot/nao/lola/sensors.h"

namespace tests {

inline constexpr std::uint64_t kCycle_ns = 12'000'000;  // of LoLA

class FakeBody {
 public:
  /// Seated, without stiffness, upright.
  FakeBody();

  robot::nao::Sensors sensors;  // LoLA's next values; tests may change any of them

  /// Moves joints with stiffness at their full speed and leaves the others; the torso continues to fall.
  void obey(const robot::nao::Actuators& actuators, float dt);

  /// Lets the torso tip over to the front, or turns it at once.
  void fall() { falls_ = true; }
  void put_upright() { turn(0, 0); }
  void lie_on_front() { turn(0, 1.5f); }
  void lie_on_back() { turn(0, -1.5f); }

  void lift() { sensors.fsr.fill(0); }
  void put_down() { sensors.fsr.fill(0.65f); }
  void press_chest(bool pressed) { sensors.touch[0] = pressed ? 1.0f : 0.0f; }
  void hold_head(bool held) { sensors.touch[1] = sensors.touch[2] = sensors.touch[3] = held ? 1.0f : 0.0f; }

 private:
  void turn(float roll, float pitch);

  bool falls_ = false;
};

}  // namespace tests
