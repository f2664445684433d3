// The movement of a body with a gait: it accelerates towards it and follows an arc. Internal to sim/motion.
#pragma once

#include <cmath>

#include "sim/motion/gait.h"
#include "sim/world/body.h"

namespace sim::motion {

/// Returns the equal angle within ±π, for |angle| <= 3π.
inline float wrapped(float angle) { return angle > kPi ? angle - 2 * kPi : angle < -kPi ? angle + 2 * kPi : angle; }

/// The tolerance for sums of rounded numbers: a change counts as possible if it exceeds the limit by a smaller share.
inline constexpr float kRounding = 1e-4f;

/// Changes `velocity` towards `wanted` by at most `most`. Returns the mean velocity over the time that `most` takes.
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
  // a change below 1 mm/s needs no mean
  if (squared < 1e-6f) return wanted;
  return wanted - 0.5f * std::sqrt(squared) / most * change;
}

/// Does the same for a turn rate.
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

/// Returns the chord of an arc of length 1, in the frame of its start: (sin a / a, (1 - cos a) / a).
inline Vec2 chord_of(float angle) {
  const float square = angle * angle;
  if (square < 0.09f) return {1 - square * (1.f / 6 - square * (1.f / 120)), angle * (0.5f - square * (1.f / 24))};
  const SinCos end = sin_cos(angle);
  return {end.sin / angle, (1 - end.cos) / angle};
}

/// A motion of the robot's frame, seen from its former pose.
struct Moved {
  Vec2 displacement;  // [m]
  Vec2 facing;        // unit vector at `angle`
  float angle;        // [rad]
};

/// Moves the body for `dt` with the gait, reached at once or within the limits of acceleration.
/// Inline, because there is one call.
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

  // the chord also yields sine and cosine of the angle
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
