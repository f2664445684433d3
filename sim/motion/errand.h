// The rest of a walking command. Internal to sim/motion.
#pragma once

#include "sim/math/vec2.h"
#include "sim/motion/command.h"

namespace sim::motion {

/// Returns the equal angle within ±π, for |angle| <= 3π.
inline float wrapped(float angle) { return angle > kPi ? angle - 2 * kPi : angle < -kPi ? angle + 2 * kPi : angle; }

/// The rest of a walking command. At the first tick of a move it equals the command.
struct Errand {
  Vec2 walk;      // by speed: [m/s, robot]; otherwise: destination [m, robot]
  float turn;     // by speed: [rad/s]; otherwise: heading on arrival [rad, robot], within ±π
  bool by_speed;  // walk_speed; otherwise walk_to
};

/// A motion of the robot's frame, seen from its former pose.
struct Moved {
  Vec2 displacement;  // [m]
  Vec2 facing;        // unit vector at `angle`
  float angle;        // [rad]
};

/// Returns the errand of a command, seen from the present pose.
inline Errand errand_of(const Command& command) {
  const bool by_speed = command.body != Command::Body::walk_to;
  return {command.walk, by_speed ? command.turn : wrapped(command.turn), by_speed};
}

/// Returns the rest of the errand, seen from the new pose.
inline Errand after(const Errand& errand, const Moved& moved) {
  if (errand.by_speed) return errand;
  return {turned_back(errand.walk - moved.displacement, moved.facing), wrapped(errand.turn - moved.angle), false};
}

}  // namespace sim::motion
