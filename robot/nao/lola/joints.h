// The joints of a Nao in LoLA's order: names, ranges and speeds.
#pragma once

#include <array>
#include <cstddef>

namespace robot::nao {

/// Joints in LoLA's order. There is no r_hip_yaw_pitch: one motor moves both legs, and the right value equals the left.
enum Joint : std::size_t {
  head_yaw,
  head_pitch,
  l_shoulder_pitch,
  l_shoulder_roll,
  l_elbow_yaw,
  l_elbow_roll,
  l_wrist_yaw,
  l_hip_yaw_pitch,
  l_hip_roll,
  l_hip_pitch,
  l_knee_pitch,
  l_ankle_pitch,
  l_ankle_roll,
  r_hip_roll,
  r_hip_pitch,
  r_knee_pitch,
  r_ankle_pitch,
  r_ankle_roll,
  r_shoulder_pitch,
  r_shoulder_roll,
  r_elbow_yaw,
  r_elbow_roll,
  r_wrist_yaw,
  l_hand,
  r_hand,
};

inline constexpr std::size_t kJoints = 25;

template <class T>
using PerJoint = std::array<T, kJoints>;

/// A range from `low` to `high`, both included [rad; hands 0 closed .. 1 open].
struct Range {
  float low, high;
};

/// Name, range and speed of a joint.
struct JointLimits {
  const char* name;  // as in proto/foresight/sensors.proto
  Range range;
  float speed;  // [rad/s; hands 1/s] of the motor without load
};

/// Returns the limits of a joint: ranges from proto/foresight/sensors.proto, speeds from Aldebaran's model of the
/// robot.
const JointLimits& limits_of(std::size_t joint);

/// Returns the nearest value within the range.
float clamp(float value, Range range);

/// Returns the range of head_pitch at the head's `yaw` [rad] in which the head does not touch the shoulders.
///
/// Source: Aldebaran's table of the shells ("anti collision limitation"), interpolated linearly. Beyond ±119.5° the
/// last row applies.
Range head_pitch_range(float yaw);

}  // namespace robot::nao
