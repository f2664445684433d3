// The command of an agent to its body.
#pragma once

#include <cstdint>

#include "sim/math/vec2.h"

namespace sim::motion {

/// A command to the body and one to the head, independent of each other. It is in force until the next command.
/// Frame: robot — origin on the ground between the feet, +x forward, +y left.
struct Command {
  enum class Body : std::uint8_t { stand, walk_speed, walk_to, kick, squat };
  enum class Head : std::uint8_t { keep, angles, look_to };

  Body body = Body::stand;
  Head head = Head::keep;
  std::uint8_t kick = 0;   // kick: index into the kick table
  bool kick_left = false;  // kick: with the left foot
  Vec2 walk;               // walk_speed: velocity [m/s]; walk_to: destination [m]
  float turn = 0;          // walk_speed: [rad/s]; walk_to: heading on arrival [rad]
  float gain = 1;          // walk_to: share of the greatest speed; kick: share of the kick's range; [0..1]
  // angles: yaw [rad, > 0 left], pitch [rad, > 0 down], unused; look_to: x, y [m], z above ground [m]
  float look[3] = {0, 0, 0};

  friend bool operator==(const Command&, const Command&) = default;
};

}  // namespace sim::motion
