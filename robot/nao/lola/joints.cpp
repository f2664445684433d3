#include "robot/nao/lola/joints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robot::nao {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180;

constexpr Range degrees(float low, float high) { return {low * kDegree, high * kDegree}; }

constexpr PerJoint<JointLimits> kLimits{{
    {"head_yaw", degrees(-119.5f, 119.5f), 8.268f},
    {"head_pitch", degrees(-38.5f, 29.5f), 7.194f},
    {"l_shoulder_pitch", degrees(-119.5f, 119.5f), 8.268f},
    {"l_shoulder_roll", degrees(-18, 76), 7.194f},
    {"l_elbow_yaw", degrees(-119.5f, 119.5f), 8.268f},
    {"l_elbow_roll", degrees(-88.5f, -2), 7.194f},
    {"l_wrist_yaw", degrees(-104.5f, 104.5f), 24.62f},
    {"l_hip_yaw_pitch", degrees(-65.62f, 42.44f), 4.162f},
    {"l_hip_roll", degrees(-21.74f, 45.29f), 4.162f},
    {"l_hip_pitch", degrees(-88, 27.73f), 6.402f},
    {"l_knee_pitch", degrees(-5.29f, 121.04f), 6.402f},
    {"l_ankle_pitch", degrees(-68.15f, 52.86f), 6.402f},
    {"l_ankle_roll", degrees(-22.79f, 44.06f), 4.162f},
    {"r_hip_roll", degrees(-45.29f, 21.74f), 4.162f},
    {"r_hip_pitch", degrees(-88, 27.73f), 6.402f},
    {"r_knee_pitch", degrees(-5.9f, 121.47f), 6.402f},
    {"r_ankle_pitch", degrees(-67.97f, 53.4f), 6.402f},
    {"r_ankle_roll", degrees(-44.06f, 22.8f), 4.162f},
    {"r_shoulder_pitch", degrees(-119.5f, 119.5f), 8.268f},
    {"r_shoulder_roll", degrees(-76, 18), 7.194f},
    {"r_elbow_yaw", degrees(-119.5f, 119.5f), 8.268f},
    {"r_elbow_roll", degrees(2, 88.5f), 7.194f},
    {"r_wrist_yaw", degrees(-104.5f, 104.5f), 24.62f},
    {"l_hand", {0, 1}, 8.33f},
    {"r_hand", {0, 1}, 8.33f},
}};

struct ShellRow {
  float yaw_deg, low_deg, high_deg;
};

// for one side; the other side is its mirror image
constexpr std::array<ShellRow, 7> kShell{{
    {0, -38.5f, 29.51f},
    {27.85f, -38.5f, 24.18f},
    {43.32f, -31.4f, 21.2f},
    {51.74f, -27.5f, 18.91f},
    {62.45f, -24.64f, 17.19f},
    {87.49f, -18.91f, 11.46f},
    {119.52f, -25.73f, 18.91f},
}};

}  // namespace

const JointLimits& limits_of(std::size_t joint) { return kLimits[joint]; }

float clamp(float value, Range range) { return std::min(std::max(value, range.low), range.high); }

Range head_pitch_range(float yaw) {
  const float yaw_deg = std::min(std::abs(yaw) / kDegree, kShell.back().yaw_deg);
  std::size_t row = 1;
  while (row + 1 < kShell.size() && yaw_deg > kShell[row].yaw_deg) ++row;
  const ShellRow &from = kShell[row - 1], &to = kShell[row];
  const float part = (yaw_deg - from.yaw_deg) / (to.yaw_deg - from.yaw_deg);
  const Range shell =
      degrees(from.low_deg + part * (to.low_deg - from.low_deg), from.high_deg + part * (to.high_deg - from.high_deg));
  // the joint's own range ends a hundredth of a degree earlier
  const Range joint = kLimits[head_pitch].range;
  return {std::max(shell.low, joint.low), std::min(shell.high, joint.high)};
}

}  // namespace robot::nao
