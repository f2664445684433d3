// Commands that people give by touching the robot.
#pragma once

#include <cstdint>

#include "robot/nao/lola/sensors.h"

namespace robot::nao {

/// A filter for the chest button and the head sensors. A single wrong frame has no effect.
class Touches {
 public:
  static constexpr int kPressFrames = 2;                         // shortest press of the chest button
  static constexpr std::uint64_t kLongPress_ns = 1'500'000'000;  // and longest: beyond it the robot itself reacts
  static constexpr int kHeldFrames = 3;                          // 36 ms of all three head sensors

  void see(const Sensors& sensors, std::uint64_t now_ns);

  /// Returns whether the chest button was released in this frame after a press.
  bool clicked() const { return clicked_; }

  /// Returns whether all three head sensors are held.
  bool head_held() const { return held_frames_ >= kHeldFrames; }

 private:
  int pressed_frames_ = 0, held_frames_ = 0;
  std::uint64_t pressed_since_ns_ = 0;
  bool clicked_ = false;
};

}  // namespace robot::nao
