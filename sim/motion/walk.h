// Walking with a speed or to a destination. Internal to sim/motion.
#pragma once

#include "sim/motion/command.h"
#include "sim/motion/motion.h"
#include "sim/world/world.h"

namespace sim::motion {

inline constexpr float kNear = 0.4f;          // [m] below this it walks in any direction, turning to its final heading
inline constexpr float kArrived = 0.01f;      // [m] below this it has arrived
inline constexpr float kArrivedTurn = 0.03f;  // [rad] likewise
inline constexpr float kBrakes = 0.7f;        // share of the acceleration for slowing down; the rest is for corrections

/// Returns the deceleration before a destination [m/s²].
inline float brake_of(const Walk& walk) {
  const float gentle = walk.forward * walk.forward / (2 * walk.slow_down);
  return gentle < kBrakes * walk.acceleration ? gentle : kBrakes * walk.acceleration;
}

/// The rest of a walking command. At the first tick of a move it equals the command.
struct Errand {
  Vec2 walk;       // walk_speed: [m/s, robot]; walk_to: destination [m, robot]
  float turn = 0;  // walk_speed: [rad/s]; walk_to: heading on arrival [rad, robot], within ±π
};

/// Returns the errand of a command, seen from the present pose.
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
