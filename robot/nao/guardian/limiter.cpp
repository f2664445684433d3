#include "robot/nao/guardian/limiter.h"

#include <algorithm>
#include <cmath>

namespace robot::nao {
namespace {

/// Limits the head's pitch so that the head is clear of the shoulders.
void keep_head_clear(PerJoint<float>& position) {
  position[head_pitch] = clamp(position[head_pitch], head_pitch_range(position[head_yaw]));
}

/// Returns `from` moved by at most `step` towards `to`, never beyond it, also with rounding.
float towards(float from, float to, float step) {
  if (std::abs(to - from) <= step) return to;
  return to > from ? std::min(from + step, to) : std::max(from - step, to);
}

bool contains(Range range, float value) { return value >= range.low && value <= range.high; }

}  // namespace

void Limiter::start(const Pose& pose) {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    pose_.position[joint] = clamp(pose.position[joint], limits_of(joint).range);
    pose_.stiffness[joint] = clamp(pose.stiffness[joint], {0, 1});
  }
  keep_head_clear(pose_.position);
}

const Pose& Limiter::soften(const PerJoint<float>& measured) {
  start({.position = measured, .stiffness = {}});
  return pose_;
}

const Pose& Limiter::next(const Pose& target, const PerJoint<float>& measured, float dt, float speed_share) {
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    if (pose_.stiffness[joint] == 0) pose_.position[joint] = clamp(measured[joint], limits_of(joint).range);
  keep_head_clear(pose_.position);

  const Pose from = pose_;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const JointLimits& limits = limits_of(joint);
    if (std::isfinite(target.position[joint]))
      pose_.position[joint] =
          towards(from.position[joint], clamp(target.position[joint], limits.range), limits.speed * speed_share * dt);
    if (std::isfinite(target.stiffness[joint]))
      pose_.stiffness[joint] =
          std::min(clamp(target.stiffness[joint], {0, 1}), from.stiffness[joint] + kStiffnessRise * dt);
  }
  // if only one of them were soft, a hand could turn it to where the other one is not allowed
  if (pose_.stiffness[head_yaw] == 0 || pose_.stiffness[head_pitch] == 0)
    pose_.stiffness[head_yaw] = pose_.stiffness[head_pitch] = 0;

  // the pitch moves out of the way first, and the yaw waits for it
  const float yaw = pose_.position[head_yaw];
  const float step = limits_of(head_pitch).speed * speed_share * dt;
  const float wanted =
      std::isfinite(target.position[head_pitch]) ? target.position[head_pitch] : from.position[head_pitch];
  pose_.position[head_pitch] = towards(from.position[head_pitch], clamp(wanted, head_pitch_range(yaw)), step);
  if (!contains(head_pitch_range(yaw), pose_.position[head_pitch])) {
    pose_.position[head_yaw] = from.position[head_yaw];
    keep_head_clear(pose_.position);
  }
  return pose_;
}

}  // namespace robot::nao
