// The gait that a walking body aims at: the nearest one within its limits. Internal to sim/motion.
//
// The functions compute both sides of each choice if they run in lanes (sim/math/lanes.h), and one side otherwise.
#pragma once

#include <cmath>

#include "sim/math/vec2.h"
#include "sim/motion/clamped.h"
#include "sim/motion/errand.h"
#include "sim/motion/luck.h"
#include "sim/motion/model.h"

namespace sim::motion {

inline constexpr float kNear = 0.4f;    // [m] below this it walks in any direction, turning to its final heading
inline constexpr float kBrakes = 0.7f;  // share of the acceleration for slowing down; the rest is for corrections
inline constexpr float kFollowing = 3;  // [1/s] turn rate per radian off the destination, walking ahead
inline constexpr float kAtOnce = 1e6f;  // [m/s²], [rad/s²] braking without limits of acceleration

/// A velocity [m/s, robot] and a turn rate [rad/s].
struct Gait {
  Vec2 velocity;
  float turn_rate = 0;
};

/// Returns the deceleration before a destination [m/s²].
inline float brake_of(const Walk& walk) {
  const float gentle = walk.forward * walk.forward / (2 * walk.slow_down);
  return gentle < kBrakes * walk.acceleration ? gentle : kBrakes * walk.acceleration;
}

/// Returns the factor by which `way` must be multiplied to be the fastest possible velocity while the body turns.
/// The possible velocities form an ellipse that shrinks with the turn rate. Infinite for a zero `way`.
inline float most_along(const Walk& walk, bool turning_costs, float turn, Vec2 way) {
  // (x / reach)² + (y / sideward)² = (1 - turn_cost * |turn| / turn_rate)², multiplied out
  const float reach = way.x >= 0 ? walk.forward : walk.backward;
  const float size = length({way.x * walk.sideward, way.y * reach}) * walk.turn_rate;
  const float left = turning_costs ? walk.turn_rate - walk.turn_cost * std::abs(turn) : walk.turn_rate;
  return left * (reach * walk.sideward) / size;
}

/// Returns the commanded velocity and turn rate, clipped to the limits of the body.
inline Gait at_speed(const Walk& walk, bool limited, const Errand& errand, const Luck& luck) {
  const float top = walk.turn_rate;
  const float turn = clamped(errand.turn, -top, top);
  const Vec2 way{errand.walk.x * luck.speed.x, errand.walk.y * luck.speed.y};
  return {lesser(1.f, most_along(walk, limited, turn, way)) * way, clamped(turn + luck.turn, -top, top)};
}

/// Returns the speed for the next `dt` after which `brake` still stops the body within the distance `left`, divided by
/// `left` [1/s]. It solves v * dt + v² / (2 * brake) = left.
inline float pace(float left, float brake, float dt) {
  const float lost = brake * dt;
  return 2 * brake / (lost + std::sqrt(lost * lost + 2 * brake * left));
}

/// Reports whether the destination is farther than kNear.
inline bool is_far(Vec2 target) { return squared_length(target) > kNear * kNear; }

/// Returns the gait to a destination farther than kNear: turn to it and walk ahead, slower while it lies to the side.
/// Slowing down is not needed yet. The sine replaces the angle: where the two differ much, the turn rate is clipped.
/// A body with the destination behind it only turns.
inline Gait towards_far(const Walk& walk, bool limited, float gain, const Errand& errand, const Luck& luck) {
  const Vec2 ahead = 1 / length(errand.walk) * errand.walk;
  const float top = gain * walk.turn_rate;
  const bool behind = ahead.x <= 0;

  const float turn = clamped(kFollowing * ahead.y, -top, top);
  const float share = limited ? 1 - walk.turn_cost * std::abs(turn) / walk.turn_rate : 1;
  const float speed = gain * walk.forward * lesser(share, luck.speed.x);
  return {{behind ? 0 : speed * ahead.x, 0},
          behind ? std::copysign(top, ahead.y) : clamped(turn + luck.turn, -top, top)};
}

/// Returns the gait to a near destination: straight to it in any direction, while turning to the heading on arrival.
inline Gait towards_near(const Walk& walk, bool limited, float gain, const Errand& errand, float dt, const Luck& luck) {
  const float top = gain * walk.turn_rate;
  const float turn_brake = limited ? kBrakes * walk.turn_acceleration : kAtOnce;
  const float turn = clamped(pace(std::abs(errand.turn), turn_brake, dt) * errand.turn, -top, top);

  // the speed from which it stops there, or the greatest possible one in that direction
  const float stopping = pace(length(errand.walk), limited ? brake_of(walk) : kAtOnce, dt);
  const Vec2 way{errand.walk.x * luck.speed.x, errand.walk.y * luck.speed.y};
  const float greatest = gain * most_along(walk, limited, turn, way);
  return {lesser(stopping, greatest) * way, clamped(turn + luck.turn, -top, top)};
}

/// Returns the gait to aim at for the next `dt`. `gain` is the share of the greatest speed [0..1], for a destination.
inline Gait gait_of(const Walk& walk, bool limited, float gain, const Errand& errand, float dt, const Luck& luck) {
  if (errand.by_speed) return at_speed(walk, limited, errand, luck);
  return is_far(errand.walk) ? towards_far(walk, limited, gain, errand, luck)
                             : towards_near(walk, limited, gain, errand, dt, luck);
}

}  // namespace sim::motion
