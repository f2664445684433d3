// Aiming the head, and the limits of its joints. Internal to sim/motion.
//
// The functions compute both sides of each choice if they run in lanes (sim/math/lanes.h), and one side otherwise.
#pragma once

#include <cmath>

#include "sim/math/angles.h"
#include "sim/math/vec2.h"
#include "sim/motion/clamped.h"
#include "sim/motion/model.h"

namespace sim::motion {

inline constexpr float kCameraHeight = 0.45f;   // [m] B-Human's assumedObservationHeight; good enough for aiming
inline constexpr float kAimTolerance = 0.015f;  // [rad] an aim with a smaller error is kept
inline constexpr float kViewCentre = 0.44f;  // [rad] below the horizon with pitch 0: the middle of both cameras' views

/// The angles of the head [rad].
struct Angles {
  float yaw;
  float pitch;
};

/// The angles of the head, and the unit vector at its yaw [robot].
struct Gaze {
  float yaw;
  float pitch;
  Vec2 look;
};

/// The pose of a body.
struct Stand {
  Vec2 position;  // [m, field]
  float heading;  // [rad]
  Vec2 facing;    // unit vector at `heading`
};

/// The limits of the pitch at some yaw [rad]: the table of `yaw_limit_at`, inverted.
struct Nod {
  float up;
  float down;
};
inline Nod nod_at(const Head& head, float yaw) {
  const float aside = std::abs(yaw);
  const float down = aside <= 0.4f ? head.pitch_down : aside <= 1.f ? 0.3f : 0.2f;
  const float up = aside <= 0.2f ? head.pitch_up : aside <= 0.3f ? -0.6f : aside <= 0.7f ? -0.5f : -0.4f;
  return {greater(up, head.pitch_up), lesser(down, head.pitch_down)};
}

/// Returns how far the head may turn to each side at this pitch without touching a shoulder [rad] (Northern Bites,
/// corpus/Kinematics.h).
inline float yaw_limit_at(const Head& head, float pitch) {
  const float low = pitch > 0.3f ? 0.4f : pitch > 0.2f ? 1.f : head.yaw_limit;
  const float limit = pitch < -0.6f ? 0.2f : pitch < -0.5f ? 0.3f : pitch < -0.4f ? 0.7f : low;
  return lesser(limit, head.yaw_limit);
}

/// Returns the angle whose tangent is up / along, within 0.004 rad, for along >= 0. `nearer` is 1 / along. Good enough
/// for aiming.
inline float elevation(float up, float along, float nearer) {
  const float height = std::abs(up);
  const bool steep = height > along;
  const float slope = steep ? along / height : height * nearer;
  const float flat = slope * (0.25f * kPi + 0.273f * (1 - slope));
  return std::copysign(steep ? 0.5f * kPi - flat : flat, up);
}

/// Returns a point that a robot saw from `told`, as it is seen from the present pose [m, robot].
inline Vec2 seen_now(Vec2 point, const Pose2& told, const Stand& now) {
  if (told.heading == now.heading && told.position == now.position) return point;
  const Vec2 in_field = told.position + turned(point, direction(told.heading));
  return turned_back(in_field - now.position, now.facing);
}

/// Returns the angles that aim at a point of this height [m]. An angle within the tolerance is kept, because the head
/// mostly follows things that hardly move. A short way needs no arc tangent.
inline Angles aimed_at(Vec2 point, float height, const Gaze& gaze) {
  const float along = greater(length(point), 1e-6f);
  const float nearer = 1 / along;
  const float pitch = elevation(kCameraHeight - height, along, nearer) - kViewCentre;

  const float off = cross(gaze.look, point) * nearer;
  const float size = dot(gaze.look, point) > 0 ? std::abs(off) : 1;
  const float yaw = size <= kAimTolerance ? gaze.yaw
                    : size < 0.2f         ? gaze.yaw + off * (1 + off * off * (1.f / 6 + 0.075f * off * off))
                                          : angle_of(point);
  return {yaw, std::abs(pitch - gaze.pitch) <= kAimTolerance ? gaze.pitch : pitch};
}

/// Reports whether no shoulder is in the way at this pitch, whatever the yaw.
inline bool is_clear(float pitch) { return (-0.4f <= pitch) & (pitch <= 0.2f); }

inline float turned_towards(float from, float to, float most) { return from + clamped(to - from, -most, most); }

/// Returns the angles that the head reaches within `dt`.
inline Angles reached(const Head& head, Angles to, float dt, Angles from) {
  const float wanted = clamped(to.yaw, -head.yaw_limit, head.yaw_limit);

  // the pitch first: clear of the shoulders at the present and at the wanted yaw
  const bool clear = is_clear(to.pitch) & is_clear(from.pitch);
  const Nod nod =
      clear ? Nod{head.pitch_up, head.pitch_down} : nod_at(head, greater(std::abs(wanted), std::abs(from.yaw)));
  const float pitch = turned_towards(from.pitch, clamped(to.pitch, nod.up, nod.down), head.pitch_speed * dt);
  const float limit = clear ? head.yaw_limit : yaw_limit_at(head, pitch);
  return {turned_towards(from.yaw, clamped(wanted, -limit, limit), head.yaw_speed * dt), pitch};
}

/// Returns `look`, the unit vector at `from`, turned to `yaw`. A small turn rotates it; each pass through straight ahead
/// computes it anew, which removes the accumulated rounding.
inline Vec2 look_at(float yaw, float from, Vec2 look) {
  const float angle = yaw - from;
  const float square = angle * angle;
  const float sine = angle * (1 - square * (1.f / 6 - square * (1.f / 120)));
  const bool little = (square < 0.04f) & (yaw * from > 0);
  return little ? turned(look, {1 - square * (0.5f - square * (1.f / 24)), sine}) : direction(yaw);
}

/// Turns the head to these angles, at once or within `dt` and the limits of its joints.
inline Gaze turned_to(const Head& head, bool limited, Angles to, float dt, const Gaze& gaze) {
  const bool stays = (to.yaw == gaze.yaw) & (to.pitch == gaze.pitch);
  if (stays) return gaze;
  const Angles end = limited ? reached(head, to, dt, {gaze.yaw, gaze.pitch}) : to;
  return {end.yaw, end.pitch, end.yaw != gaze.yaw ? look_at(end.yaw, gaze.yaw, gaze.look) : gaze.look};
}

}  // namespace sim::motion
