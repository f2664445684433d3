// The cognitive controller's own data about a robot, which the robot itself does not know.
#pragma once

#include <cstdint>

#include "sim/agent/beliefs.h"
#include "sim/math/tick.h"
#include "sim/math/vec2.h"

namespace sim::perception {

inline constexpr float kTurnUnit = 1e-4f;  // [rad] chosen so that 16 bits suffice: State is small

/// The hidden errors of a robot's odometry and pose, and its packet.
struct Cognition {
  float odometry_scale = 1;  // believed way / true way, of this robot in this game
  float turn_scale = 1;      // likewise for turning
  Pose2 last;                // [field] true pose when odometry was last read
  float walked = 0;          // [m] since the last look at the marks
  std::uint16_t turned = 0;  // [kTurnUnit] likewise, at most 6.5 rad
  bool flipped = false;      // the believed pose is turned round by π
  bool on_air = false;       // `packet` has not arrived yet
  agent::Mate packet;        // the newest packet; `packet.sent` is the time of sending
};

}  // namespace sim::perception
