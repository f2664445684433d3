// The gait that a walking body aims at: the nearest one within its limits. Internal to sim/motion.
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/motion/walk.h"
#include "sim/world/body.h"

namespace sim::motion {

inline constexpr float kFollowing = 3;  // [1/s] turn rate per radian off the destination, walking ahead
inline constexpr float kAtOnce = 1e6f;  // [m/s²], [rad/s²] braking without limits of acceleration

/// The noise of one step: factors of the forward and the sideward speed, and an added turn rate [rad/s].
struct Luck {
  Vec2 speed{1, 1};
  float turn = 0;
};

/// A velocity [m/s, robot] and a turn rate [rad/s].
struct Gait {
  Vec2 velocity;
  float turn_rate = 0;
};

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
inline Gait at_speed(const Walk& walk, bool limited, Vec2 velocity, float turn, const Luck& luck) {
  const float top = walk.turn_rate;
  turn = std::clamp(turn, -top, top);
  const Vec2 way{velocity.x * luck.speed.x, velocity.y * luck.speed.y};
  return {std::min(1.f, most_along(walk, limited, turn, way)) * way, std::clamp(turn + luck.turn, -top, top)};
}

/// Returns the speed for the next `dt` after which `brake` still stops the body within the distance `left`, divided by
/// `left` [1/s]. It solves v * dt + v² / (2 * brake) = left.
inline float pace(float left, float brake, float dt) {
  const float lost = brake * dt;
  return 2 * brake / (lost + std::sqrt(lost * lost + 2 * brake * left));
}

/// Returns the gait to a destination farther than kNear: turn to it and walk ahead, slower while it lies to the side.
/// Slowing down is not needed yet. The sine replaces the angle: where the two differ much, the turn rate is clipped.
inline Gait towards_far(const Walk& walk, bool limited, float gain, Vec2 target, float squared, const Luck& luck) {
  const Vec2 ahead = 1 / std::sqrt(squared) * target;
  const float top = gain * walk.turn_rate;
  if (ahead.x <= 0) return {{}, std::copysign(top, ahead.y)};

  const float turn = std::clamp(kFollowing * ahead.y, -top, top);
  const float share = limited ? 1 - walk.turn_cost * std::abs(turn) / walk.turn_rate : 1;
  const float speed = gain * walk.forward * std::min(share, luck.speed.x);
  return {{speed * ahead.x, 0}, std::clamp(turn + luck.turn, -top, top)};
}

/// Returns the gait to a near destination: straight to it in any direction, while turning to the heading on arrival.
inline Gait towards_near(const Walk& walk, bool limited, float gain, const Errand& errand, float dt, const Luck& luck) {
  const float top = gain * walk.turn_rate;
  const float turn_brake = limited ? kBrakes * walk.turn_acceleration : kAtOnce;
  const float turn = std::clamp(pace(std::abs(errand.turn), turn_brake, dt) * errand.turn, -top, top);

  // the speed from which it stops there, or the greatest possible one in that direction
  const float stopping = pace(length(errand.walk), limited ? brake_of(walk) : kAtOnce, dt);
  const Vec2 way{errand.walk.x * luck.speed.x, errand.walk.y * luck.speed.y};
  const float greatest = gain * most_along(walk, limited, turn, way);
  return {std::min(stopping, greatest) * way, std::clamp(turn + luck.turn, -top, top)};
}

}  // namespace sim::motion
