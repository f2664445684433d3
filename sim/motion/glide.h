// The movement of a body with a gait: it accelerates towards it and follows an arc. Internal to sim/motion.
//
// The functions compute both sides of each choice if they run in lanes (sim/math/lanes.h), and one side otherwise.
#pragma once

#include <cmath>

#include "sim/motion/gait.h"

namespace sim::motion {

/// The tolerance for sums of rounded numbers: a change counts as possible if it exceeds the limit by a smaller share.
inline constexpr float kRounding = 1e-4f;

/// The part of a body that walking changes, with the units and frames of Body.
struct Walking {
  Vec2 position;
  float heading;
  Vec2 facing;
  Vec2 velocity;
  float turn_rate;
  float walked;
};

/// A value that changes within limits: its mean over the time that the greatest change takes, and its end.
template <class Value>
struct Change {
  Value mean;
  Value end;
};

/// Changes `velocity` towards `wanted` by at most `most`.
inline Change<Vec2> approach(Vec2 velocity, Vec2 wanted, float most) {
  const Vec2 change = wanted - velocity;
  const float squared = squared_length(change), size = std::sqrt(squared);
  if (squared > (1 + 2 * kRounding) * most * most) {
    const Vec2 gained = most / size * change;
    return {velocity + 0.5f * gained, velocity + gained};
  }
  // a change below 1 mm/s needs no mean
  return {squared < 1e-6f ? wanted : wanted - 0.5f * size / most * change, wanted};
}

/// Does the same for a turn rate.
inline Change<float> approach(float rate, float wanted, float most) {
  const float change = wanted - rate, size = std::abs(change);
  if (size > (1 + kRounding) * most) {
    const float gained = std::copysign(most, change);
    return {rate + 0.5f * gained, rate + gained};
  }
  return {size < 1e-3f ? wanted : wanted - 0.5f * size / most * change, wanted};
}

/// Returns the chord of an arc of length 1, in the frame of its start: (sin a / a, (1 - cos a) / a).
inline Vec2 chord_of(float angle) {
  const float square = angle * angle;
  if (square < 0.09f) return {1 - square * (1.f / 6 - square * (1.f / 120)), angle * (0.5f - square * (1.f / 24))};
  const SinCos end = sin_cos(angle);
  return {end.sin / angle, (1 - end.cos) / angle};
}

/// The body after a glide, and its motion.
struct Glide {
  Walking body;
  Moved moved;
};

/// Moves the body for `dt` with the gait, reached at once or within the limits of acceleration.
inline Glide glide(const Walk& walk, bool limited, const Gait& gait, float dt, const Walking& body) {
  Change<Vec2> velocity{gait.velocity, gait.velocity};
  Change<float> rate{gait.turn_rate, gait.turn_rate};
  if (limited) {
    velocity = approach(body.velocity, gait.velocity, walk.acceleration * dt);
    rate = approach(body.turn_rate, gait.turn_rate, walk.turn_acceleration * dt);
  }

  // the chord also yields sine and cosine of the angle
  const Vec2 arc = dt * velocity.mean;
  const float angle = rate.mean * dt;
  const Vec2 chord = chord_of(angle);
  const Moved moved{turned(arc, chord), {1 - angle * chord.y, angle * chord.x}, angle};
  return {{body.position + turned(moved.displacement, body.facing), wrapped(body.heading + angle),
           turned(body.facing, moved.facing), velocity.end, rate.end, body.walked + length(arc)},
          moved};
}

}  // namespace sim::motion
