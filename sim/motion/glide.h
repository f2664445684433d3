// How a body moves on with a gait: towards its speeds, along an arc. Internal to sim/motion.
#pragma once

#include <cmath>

#include "sim/motion/gait.h"
#include "sim/world/body.h"

namespace sim::motion {

/// An angle beyond ±π, but not beyond ±3π, as the equal one within.
inline float wrapped(float angle) { return angle > kPi ? angle - 2 * kPi : angle < -kPi ? angle + 2 * kPi : angle; }

/// A change that is greater than what is possible by less than this share is possible: sums of rounded numbers.
inline constexpr float kRounding = 1e-4f;

/// Leads `velocity` towards `wanted`, by at most `most`, and returns its mean over the time that `most` takes.
inline Vec2 approach(Vec2& velocity, Vec2 wanted, float most) {
  const Vec2 change = wanted - velocity;
  const float squared = squared_length(change);
  if (squared > (1 + 2 * kRounding) * most * most) {
    const Vec2 gained = most / std::sqrt(squared) * change;
    const Vec2 mean = velocity + 0.5f * gained;
    velocity += gained;
    return mean;
  }
  velocity = wanted;
  // 1 mm/s is not felt
  if (squared < 1e-6f) return wanted;
  return wanted - 0.5f * std::sqrt(squared) / most * change;
}

/// Likewise a turn rate.
inline float approach(float& rate, float wanted, float most) {
  const float change = wanted - rate;
  const float size = std::abs(change);
  if (size > (1 + kRounding) * most) {
    const float gained = std::copysign(most, change);
    const float mean = rate + 0.5f * gained;
    rate += gained;
    return mean;
  }
  rate = wanted;
  if (size < 1e-3f) return wanted;
  return wanted - 0.5f * size / most * change;
}

/// What the chord of an arc is to the arc, seen from where it begins: (sin a / a, (1 - cos a) / a).
inline Vec2 chord_of(float angle) {
  const float square = angle * angle;
  if (square < 0.09f) return {1 - square * (1.f / 6 - square * (1.f / 120)), angle * (0.5f - square * (1.f / 24))};
  const SinCos end = sin_cos(angle);
  return {end.sin / angle, (1 - end.cos) / angle};
}

/// A motion of the robot's frame: seen from where it was, [m] and a unit vector, and the angle of that [rad].
struct Moved {
  Vec2 displacement;
  Vec2 facing;
  float angle;
};

/// Moves the body for `dt` towards the gait, at once or within its accelerations. Inline, because it is called once.
[[gnu::always_inline]] inline Moved glide(const Walk& walk, bool limited, const Gait& gait, float dt, Body& body) {
  Vec2 velocity = gait.velocity;
  float rate = gait.turn_rate;
  if (limited) {
    velocity = approach(body.velocity, velocity, walk.acceleration * dt);
    rate = approach(body.turn_rate, rate, walk.turn_acceleration * dt);
  } else {
    body.velocity = velocity;
    body.turn_rate = rate;
  }

  // the chord of an angle has both functions of the angle in it
  const Vec2 arc = dt * velocity;
  const float angle = rate * dt;
  const Vec2 chord = chord_of(angle);
  const Moved moved{turned(arc, chord), {1 - angle * chord.y, angle * chord.x}, angle};

  body.walked += length(arc);
  body.position += turned(moved.displacement, body.facing);
  body.facing = turned(body.facing, moved.facing);
  body.heading = wrapped(body.heading + angle);
  return moved;
}

}  // namespace sim::motion
