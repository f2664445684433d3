// What the cognitive controller keeps for a robot beside its beliefs.
#pragma once

#include <cstdint>

#include "sim/agent/beliefs.h"
#include "sim/math/tick.h"
#include "sim/math/vec2.h"

namespace sim::perception {

inline constexpr float kTurnUnit = 1e-4f;  // [rad]: 16 bits have to do, State is small

struct Cognition {
  float odometry_scale = 1;  // of this robot in this game: walked, as believed / as is
  float turn_scale = 1;      // likewise of turning
  Pose2 last;                // [field] where it truly was when odometry was last read
  float walked = 0;          // [m] since it last looked at the marks
  std::uint16_t turned = 0;  // [kTurnUnit] likewise, at most 6.5 rad
  bool flipped = false;      // believes the field turned by π
  bool on_air = false;       // its packet is on the way
  agent::Mate packet;        // the last packet, on its way or arrived; `packet.sent` is when it last sent
};

}  // namespace sim::perception
