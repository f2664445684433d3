// Walking: by speed or to a destination. Internal to sim/motion.
#pragma once

#include "sim/motion/command.h"
#include "sim/motion/motion.h"
#include "sim/world/world.h"

namespace sim::motion {

inline constexpr float kNear = 0.4f;          // [m] nearer it walks in any direction, facing as it shall on arrival
inline constexpr float kArrived = 0.01f;      // [m] nearer it has arrived
inline constexpr float kArrivedTurn = 0.03f;  // [rad] likewise
inline constexpr float kBrakes = 0.7f;  // share of the acceleration used to slow down; the rest is for corrections

/// [m/s²] at which it slows down before a destination.
inline float brake_of(const Walk& walk) {
  const float gentle = walk.forward * walk.forward / (2 * walk.slow_down);
  return gentle < kBrakes * walk.acceleration ? gentle : kBrakes * walk.acceleration;
}

/// What is left of the walking a command asked for; at the first tick of a move it is the command's own.
struct Errand {
  Vec2 walk;       // walk_speed: [m/s, robot]; walk_to: where to [m, robot]
  float turn = 0;  // walk_speed: [rad/s]; walk_to: heading on arrival [rad, robot], within ±π
};

/// `command`'s errand, seen from where the body stands now.
inline Errand errand_of(const Command& command) {
  Errand errand{command.walk, command.turn};
  if (command.body != Command::Body::walk_to) return errand;
  if (errand.turn > kPi) errand.turn -= 2 * kPi;
  if (errand.turn < -kPi) errand.turn += 2 * kPi;
  return errand;
}

/// Stands, starts, walks or stops for `left` ticks from `now` on.
void walk(const MotionParams& params, const Command& command, int robot, Tick now, Tick left, World& world);

}  // namespace sim::motion
