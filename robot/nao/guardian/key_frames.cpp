#include "robot/nao/guardian/key_frames.h"

#include <algorithm>
#include <cassert>

namespace robot::nao {
namespace {

/// A pose with left and right alike.
struct Halves {
  float head_yaw = 0, head_pitch = 0;                                                         // [rad]
  float shoulder_pitch, shoulder_roll, elbow_yaw, elbow_roll, wrist_yaw = 0;                  // [rad] of the left arm
  float hip_yaw_pitch = 0, hip_roll = 0, hip_pitch, knee_pitch, ankle_pitch, ankle_roll = 0;  // [rad] of the left leg
};

/// A joint of the left side and its twin.
struct Pair {
  Joint left, right;
  float sign;  // of the right angle of the same pose
};
constexpr Pair kPairs[] = {{l_shoulder_pitch, r_shoulder_pitch, 1},
                           {l_shoulder_roll, r_shoulder_roll, -1},
                           {l_elbow_yaw, r_elbow_yaw, -1},
                           {l_elbow_roll, r_elbow_roll, -1},
                           {l_wrist_yaw, r_wrist_yaw, -1},
                           {l_hip_roll, r_hip_roll, -1},
                           {l_hip_pitch, r_hip_pitch, 1},
                           {l_knee_pitch, r_knee_pitch, 1},
                           {l_ankle_pitch, r_ankle_pitch, 1},
                           {l_ankle_roll, r_ankle_roll, -1},
                           {l_hand, r_hand, 1}};

constexpr PerJoint<float> both(const Halves& half) {
  PerJoint<float> pose{};
  pose[head_yaw] = half.head_yaw;
  pose[head_pitch] = half.head_pitch;
  pose[l_shoulder_pitch] = half.shoulder_pitch;
  pose[l_shoulder_roll] = half.shoulder_roll;
  pose[l_elbow_yaw] = half.elbow_yaw;
  pose[l_elbow_roll] = half.elbow_roll;
  pose[l_wrist_yaw] = half.wrist_yaw;
  pose[l_hip_yaw_pitch] = half.hip_yaw_pitch;
  pose[l_hip_roll] = half.hip_roll;
  pose[l_hip_pitch] = half.hip_pitch;
  pose[l_knee_pitch] = half.knee_pitch;
  pose[l_ankle_pitch] = half.ankle_pitch;
  pose[l_ankle_roll] = half.ankle_roll;
  for (const auto& [left, right, sign] : kPairs) pose[right] = sign * pose[left];
  return pose;
}

constexpr PerJoint<float> kStand = both({.shoulder_pitch = 1.5f,
                                         .shoulder_roll = 0.15f,
                                         .elbow_yaw = -0.6f,
                                         .elbow_roll = -0.4f,
                                         .hip_pitch = -0.41f,
                                         .knee_pitch = 0.8f,
                                         .ankle_pitch = -0.39f});

// calves and thighs touch, so the robot keeps this pose without stiffness
constexpr PerJoint<float> kSquat = both({.shoulder_pitch = 1.5f,
                                         .shoulder_roll = 0.2f,
                                         .elbow_yaw = -0.6f,
                                         .elbow_roll = -0.8f,
                                         .hip_pitch = -0.87f,
                                         .knee_pitch = 2.05f,
                                         .ankle_pitch = -1.18f});

constexpr PerJoint<float> kTuck = both({.head_pitch = 0.0f,
                                        .shoulder_pitch = 1.2f,
                                        .shoulder_roll = 0.1f,
                                        .elbow_yaw = -0.6f,
                                        .elbow_roll = -1.4f,
                                        .hip_pitch = -0.8f,
                                        .knee_pitch = 1.2f,
                                        .ankle_pitch = -0.4f});

constexpr KeyFrame kStandUp[] = {
    {.position = kSquat, .stiffness = 0.8f, .seconds = 1.5f},
    {.position = kStand, .stiffness = 0.9f, .seconds = 1.5f, .needs_feet = true},
};
constexpr KeyFrame kToStand[] = {{.position = kStand, .stiffness = 0.9f, .seconds = 1.2f}};
constexpr KeyFrame kSit[] = {{.position = kSquat, .stiffness = 0.8f, .seconds = 1.8f}};
constexpr KeyFrame kTuckIn[] = {{.position = kTuck, .stiffness = 0.3f, .seconds = 0.4f}};

/// Returns a smooth step from 0 to 1 for `part` from 0 to 1, with speed 0 at both ends.
float smooth(float part) { return part * part * (3 - 2 * part); }

}  // namespace

KeyFrames stand_up() { return kStandUp; }
KeyFrames stand() { return kToStand; }
KeyFrames sit() { return kSit; }
KeyFrames tuck() { return kTuckIn; }

const KeyFrame& stand_pose() { return kToStand[0]; }

PerJoint<float> mirrored(const PerJoint<float>& positions) {
  PerJoint<float> other = positions;
  for (const auto& [left, right, sign] : kPairs) {
    other[left] = sign * positions[right];
    other[right] = sign * positions[left];
  }
  other[head_yaw] = -positions[head_yaw];
  return other;
}

void Player::play(KeyFrames motion, const PerJoint<float>& start, float longer) {
  motion_ = motion;
  longer_ = longer;
  from_ = start;
  frame_ = 0;
  elapsed_ = 0;
}

Pose Player::next(float dt) {
  assert(!motion_.empty() && "a motion is played before it is asked for");
  elapsed_ += dt;
  const KeyFrame& frame = this->frame();
  const float seconds = longer_ * frame.seconds;
  const float part = finished() ? 1 : smooth(std::min(elapsed_ / seconds, 1.0f));
  Pose pose;
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    pose.position[joint] =
        part == 1 ? frame.position[joint] : from_[joint] + part * (frame.position[joint] - from_[joint]);
  pose.stiffness.fill(frame.stiffness);
  if (!finished() && elapsed_ >= seconds) {
    from_ = frame.position;
    elapsed_ = 0;
    ++frame_;
  }
  return pose;
}

float Player::remaining() const {
  float seconds = -elapsed_;
  for (std::size_t frame = frame_; frame < motion_.size(); ++frame) seconds += longer_ * motion_[frame].seconds;
  return finished() ? 0 : seconds;
}

}  // namespace robot::nao
