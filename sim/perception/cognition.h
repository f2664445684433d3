// What the cognitive controller keeps for a robot beside its beliefs.
#pragma once

#include "sim/agent/beliefs.h"
#include "sim/math/tick.h"
#include "sim/math/vec2.h"

namespace sim::perception {

struct Cognition {
  Vec2 odometry_scale{1, 1};  // of this robot in this game: walked, as believed / as is
  float turn_scale = 1;
  float walked = 0;           // [m] since localisation was last updated
  float turned = 0;           // [rad]
  bool flipped = false;       // believes the field turned by π
  Tick last_packet = kNever;  // when it last sent
  Tick packet_due = kNever;   // when the packet on its way arrives; kNever: none is
  agent::Mate packet;         // the packet on its way
};

}  // namespace sim::perception
