#include "sim/motion/head.h"

#include <algorithm>
#include <cmath>

#include "sim/math/angles.h"
#include "sim/motion/motion.h"

namespace sim::motion {
namespace {

constexpr float kCameraHeight = 0.45f;  // [m] B-Human's assumedObservationHeight; good enough for aiming
constexpr float kTolerance = 0.015f;    // [rad] an aim with a smaller error is kept
constexpr float kViewCentre = 0.44f;    // [rad] below the horizon with pitch 0: the middle of both cameras' views

/// The angles of the head [rad].
struct Angles {
  float yaw;
  float pitch;
};

/// The limits of the pitch at some yaw [rad]: the table of `yaw_limit_at`, inverted.
struct Nod {
  float up;
  float down;
};
Nod nod_at(const Head& head, float yaw) {
  const float aside = std::abs(yaw);
  const float down = aside <= 0.4f ? head.pitch_down : aside <= 1.f ? 0.3f : 0.2f;
  const float up = aside <= 0.2f ? head.pitch_up : aside <= 0.3f ? -0.6f : aside <= 0.7f ? -0.5f : -0.4f;
  return {std::max(up, head.pitch_up), std::min(down, head.pitch_down)};
}

/// Returns the angle whose tangent is up / along, within 0.004 rad, for along >= 0. `nearer` is 1 / along. Good enough
/// for aiming.
float elevation(float up, float along, float nearer) {
  const float height = std::abs(up);
  const bool steep = height > along;
  const float slope = steep ? along / height : height * nearer;
  const float flat = slope * (0.25f * kPi + 0.273f * (1 - slope));
  return std::copysign(steep ? 0.5f * kPi - flat : flat, up);
}

/// Returns the angles that aim at `look`. An angle within the tolerance is kept, because the head mostly follows things
/// that hardly move. A short way needs no arc tangent.
Angles aimed_at(const float (&look)[3], const Pose2& told, const Body& body) {
  Vec2 point{look[0], look[1]};
  if (told.heading != body.heading || told.position != body.position) {
    const Vec2 in_field = told.position + turned(point, direction(told.heading));
    point = turned_back(in_field - body.position, body.facing);
  }
  const float along = std::max(length(point), 1e-6f);
  const float nearer = 1 / along;
  const float pitch = elevation(kCameraHeight - look[2], along, nearer) - kViewCentre;

  const float off = cross(body.look, point) * nearer;
  const float size = dot(body.look, point) > 0 ? std::abs(off) : 1;
  const float yaw = size <= kTolerance ? body.head_yaw
                    : size < 0.2f      ? body.head_yaw + off * (1 + off * off * (1.f / 6 + 0.075f * off * off))
                                       : angle_of(point);
  return {yaw, std::abs(pitch - body.head_pitch) <= kTolerance ? body.head_pitch : pitch};
}

/// Reports whether no shoulder is in the way at this pitch, whatever the yaw.
bool is_clear(float pitch) { return -0.4f <= pitch && pitch <= 0.2f; }

/// Turns the head to `yaw`. A small turn rotates the present `look`; each pass through straight ahead computes it anew,
/// which removes the accumulated rounding.
void turn_yaw(float yaw, Body& body) {
  const float angle = yaw - body.head_yaw;
  const float square = angle * angle;
  const bool little = square < 0.04f && yaw * body.head_yaw > 0;
  body.head_yaw = yaw;
  if (little) {
    const float sine = angle * (1 - square * (1.f / 6 - square * (1.f / 120)));
    body.look = turned(body.look, {1 - square * (0.5f - square * (1.f / 24)), sine});
  } else {
    const SinCos now = sin_cos(yaw);
    body.look = {now.cos, now.sin};
  }
}

float turned_towards(float from, float to, float most) { return from + std::clamp(to - from, -most, most); }

}  // namespace

float yaw_limit_at(const Head& head, float pitch) {
  float limit = head.yaw_limit;
  if (pitch > 0.3f)
    limit = 0.4f;
  else if (pitch > 0.2f)
    limit = 1.f;
  else if (pitch < -0.6f)
    limit = 0.2f;
  else if (pitch < -0.5f)
    limit = 0.3f;
  else if (pitch < -0.4f)
    limit = 0.7f;
  return std::min(limit, head.yaw_limit);
}

namespace {

/// Turns the head of one robot.
void turn_head(const MotionParams& params, const Command& command, const Pose2& told, Tick steps, Body& body) {
  const Head& head = params.model.head;
  if (command.head == Command::Head::keep || body.doing >= Body::Doing::fallen) return;
  const bool aims = command.head == Command::Head::look_to;
  Angles to = aims ? aimed_at(command.look, told, body) : Angles{command.look[0], command.look[1]};
  if (to.yaw == body.head_yaw && to.pitch == body.head_pitch) return;

  if (params.effects.head_limits) {
    const float dt = static_cast<float>(steps) * kTickDuration;
    to.yaw = std::clamp(to.yaw, -head.yaw_limit, head.yaw_limit);

    // the pitch first: clear of the shoulders at the present and at the wanted yaw
    Nod nod{head.pitch_up, head.pitch_down};
    const bool clear = is_clear(to.pitch) && is_clear(body.head_pitch);
    if (!clear) nod = nod_at(head, std::max(std::abs(to.yaw), std::abs(body.head_yaw)));
    to.pitch = turned_towards(body.head_pitch, std::clamp(to.pitch, nod.up, nod.down), head.pitch_speed * dt);
    const float limit = clear ? head.yaw_limit : yaw_limit_at(head, to.pitch);
    to.yaw = turned_towards(body.head_yaw, std::clamp(to.yaw, -limit, limit), head.yaw_speed * dt);
  }

  body.head_pitch = to.pitch;
  if (to.yaw != body.head_yaw) turn_yaw(to.yaw, body);
}

}  // namespace

void turn_heads(const MotionParams& params, std::span<const Mover> movers) {
  for (const Mover& mover : movers)
    if (mover.head_steps > 0)
      turn_head(params, *mover.command, *mover.told, mover.head_steps, mover.world->bodies[mover.robot]);
}

}  // namespace sim::motion
