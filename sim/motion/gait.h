// What a walking body aims at: the nearest gait it is capable of. Internal to sim/motion.
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/motion/walk.h"
#include "sim/world/body.h"

namespace sim::motion {

inline constexpr float kFollowing = 3;  // [1/s] how soon a body that walks ahead faces where it goes
inline constexpr float kAtOnce = 1e6f;  // [m/s²], [rad/s²] the brake of a body without limits of acceleration

/// The luck of one step: factors of the forward and the sideward speed, and a turn rate [rad/s] on top.
struct Luck {
  Vec2 speed{1, 1};
  float turn = 0;
};

/// Velocity [m/s, robot] and turn rate [rad/s].
struct Gait {
  Vec2 velocity;
  float turn_rate = 0;
};

/// The share of the velocity `way` of which the body is capable while it turns: what it can reach is an ellipse, smaller
/// the faster it turns. Infinite for none.
inline float most_along(const Walk& walk, bool turning_costs, float turn, Vec2 way) {
  // (x / reach)² + (y / sideward)² = (1 - turn_cost * |turn| / turn_rate)², multiplied out
  const float reach = way.x >= 0 ? walk.forward : walk.backward;
  const float size = length({way.x * walk.sideward, way.y * reach}) * walk.turn_rate;
  const float left = turning_costs ? walk.turn_rate - walk.turn_cost * std::abs(turn) : walk.turn_rate;
  return left * (reach * walk.sideward) / size;
}

/// As the command says, as far as the body is capable of it.
inline Gait at_speed(const Walk& walk, bool limited, Vec2 velocity, float turn, const Luck& luck) {
  const float top = walk.turn_rate;
  turn = std::clamp(turn, -top, top);
  const Vec2 way{velocity.x * luck.speed.x, velocity.y * luck.speed.y};
  return {std::min(1.f, most_along(walk, limited, turn, way)) * way, std::clamp(turn + luck.turn, -top, top)};
}

/// [1/s] The speed to keep for the next `dt` so that `brake` then still stops within what is left, as share of that:
/// v * dt + v² / (2 * brake) = left.
inline float pace(float left, float brake, float dt) {
  const float lost = brake * dt;
  return 2 * brake / (lost + std::sqrt(lost * lost + 2 * brake * left));
}

/// To a destination farther than kNear: turns to it and walks ahead, the slower the less it lies ahead. It is not yet
/// time to slow down. The sine will do for the angle: wherever they differ much the body turns as fast as it can.
inline Gait towards_far(const Walk& walk, bool limited, float gain, Vec2 target, float squared, const Luck& luck) {
  const Vec2 ahead = 1 / std::sqrt(squared) * target;
  const float top = gain * walk.turn_rate;
  if (ahead.x <= 0) return {{}, std::copysign(top, ahead.y)};

  const float turn = std::clamp(kFollowing * ahead.y, -top, top);
  const float share = limited ? 1 - walk.turn_cost * std::abs(turn) / walk.turn_rate : 1;
  const float speed = gain * walk.forward * std::min(share, luck.speed.x);
  return {{speed * ahead.x, 0}, std::clamp(turn + luck.turn, -top, top)};
}

/// To one that is near: straight to it in any direction, while turning to the heading it shall have there.
inline Gait towards_near(const Walk& walk, bool limited, float gain, const Errand& errand, float dt, const Luck& luck) {
  const float top = gain * walk.turn_rate;
  const float turn_brake = limited ? kBrakes * walk.turn_acceleration : kAtOnce;
  const float turn = std::clamp(pace(std::abs(errand.turn), turn_brake, dt) * errand.turn, -top, top);

  // the pace at which it stops there, or the greatest of which it is capable in that direction
  const float stopping = pace(length(errand.walk), limited ? brake_of(walk) : kAtOnce, dt);
  const Vec2 way{errand.walk.x * luck.speed.x, errand.walk.y * luck.speed.y};
  const float greatest = gain * most_along(walk, limited, turn, way);
  return {std::min(stopping, greatest) * way, std::clamp(turn + luck.turn, -top, top)};
}

}  // namespace sim::motion
