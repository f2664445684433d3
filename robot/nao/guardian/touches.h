// What people say by touching the robot.
#pragma once

#include <cstdint>

#include "robot/nao/lola/sensors.h"

namespace robot::nao {

/// A single frame that reads wrong says nothing.
class Touches {
 public:
  static constexpr int kPressFrames = 2;  // the chest button counts from here on
  static constexpr std::uint64_t kLongPress_ns =
      1'500'000'000;                     // and no longer: that means something else to the robot
  static constexpr int kHeldFrames = 3;  // 36 ms of all three head sensors

  void see(const Sensors& sensors, std::uint64_t now_ns);

  /// The chest button was pressed and has just been released.
  bool clicked() const { return clicked_; }

  /// All three head sensors are held.
  bool head_held() const { return held_frames_ >= kHeldFrames; }

 private:
  int pressed_frames_ = 0, held_frames_ = 0;
  std::uint64_t pressed_since_ns_ = 0;
  bool clicked_ = false;
};

}  // namespace robot::nao
