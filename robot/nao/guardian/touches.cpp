#include "robot/nao/guardian/touches.h"

#include <algorithm>

namespace robot::nao {

void Touches::see(const Sensors& sensors, std::uint64_t now_ns) {
  const auto touched = [&](std::size_t field) { return sensors.touch[field] > 0.5f; };
  held_frames_ = touched(1) && touched(2) && touched(3) ? std::min(held_frames_ + 1, kHeldFrames) : 0;

  const bool pressed = touched(0);
  clicked_ = !pressed && pressed_frames_ >= kPressFrames && now_ns - pressed_since_ns_ < kLongPress_ns;
  if (pressed && pressed_frames_ == 0) pressed_since_ns_ = now_ns;
  pressed_frames_ = pressed ? std::min(pressed_frames_ + 1, kPressFrames) : 0;
}

}  // namespace robot::nao
