// The joints of a Nao in LoLA's order: their names, how far they turn and how fast.
#pragma once

#include <array>
#include <cstddef>

namespace robot::nao {

/// LoLA's order. There is no r_hip_yaw_pitch: one motor moves both legs, and the right one equals the left.
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

/// From `low` to `high`, both included [rad; hands 0 closed .. 1 open].
struct Range {
  float low, high;
};

/// What a joint can do.
struct JointLimits {
  const char* name;  // as in proto/foresight/sensors.proto
  Range range;
  float speed;  // [rad/s; hands 1/s] that the motor reaches without load
};

/// Ranges as in proto/foresight/sensors.proto; speeds as in Aldebaran's model of the robot.
const JointLimits& limits_of(std::size_t joint);

/// The nearest value within the range.
float clamp(float value, Range range);

/// How far head_pitch may turn at that head_yaw [rad], so that the head does not meet the shoulders: Aldebaran's table of
/// the shells ("anti collision limitation"), straight lines between its rows. Beyond ±119.5° as at the end.
Range head_pitch_range(float yaw);

}  // namespace robot::nao
