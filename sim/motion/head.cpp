#include "sim/motion/head.h"

#include <algorithm>
#include <cmath>

#include "sim/math/angles.h"

namespace sim::motion {
namespace {

constexpr float kCameraHeight = 0.45f;  // [m] BH assumedObservationHeight; aiming needs it no better
constexpr float kYawTolerance = 0.02f;  // [rad] to which look_to aims
constexpr float kViewCentre = 0.44f;    // [rad] below the horizon with pitch 0: the middle of both cameras' views

struct Angles {
  float yaw;
  float pitch;
};

// how far up and down the head may nod at this yaw: the table of `yaw_limit_at`, read the other way round
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

// atan2(up, along) within 0.005 for along >= 0: nodding needs it no better
float elevation(float up, float along) {
  const float height = std::abs(up);
  const bool steep = height > along;
  const float slope = steep ? along / height : height / std::max(along, 1e-6f);
  const float flat = slope / (1 + 0.28f * slope * slope);
  return std::copysign(steep ? 0.5f * kPi - flat : flat, up);
}

Angles wanted(const Command& command, const Body& body) {
  if (command.head == Command::Head::angles) return {command.look[0], command.look[1]};
  const Vec2 point{command.look[0], command.look[1]};
  const float along = length(point);
  const float pitch = elevation(kCameraHeight - command.look[2], along) - kViewCentre;

  // a yaw that is all but right stays: most of the time the head follows what hardly moves
  const bool right = std::abs(cross(body.look, point)) <= kYawTolerance * along && dot(body.look, point) > 0;
  return {right ? body.head_yaw : angle_of(point), pitch};
}

float approach(float from, float to, float most) { return from + std::clamp(to - from, -most, most); }

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

void turn_head(const Means& means, const Command& command, Tick steps, Body& body) {
  const Head& head = means.model.head;
  Angles to = wanted(command, body);

  if (means.effects.head_limits) {
    const float dt = static_cast<float>(steps) * kTickDuration;
    to.yaw = std::clamp(to.yaw, -head.yaw_limit, head.yaw_limit);

    // the pitch first: clear of the shoulders both where the head is and where it goes
    const Nod nod = nod_at(head, std::max(std::abs(to.yaw), std::abs(body.head_yaw)));
    to.pitch = approach(body.head_pitch, std::clamp(to.pitch, nod.up, nod.down), head.pitch_speed * dt);
    const float limit = yaw_limit_at(head, to.pitch);
    to.yaw = approach(body.head_yaw, std::clamp(to.yaw, -limit, limit), head.yaw_speed * dt);
  }

  body.head_pitch = to.pitch;
  if (to.yaw == body.head_yaw) return;
  body.head_yaw = to.yaw;
  const SinCos yaw = sin_cos(to.yaw);
  body.look = {yaw.cos, yaw.sin};
}

}  // namespace sim::motion
