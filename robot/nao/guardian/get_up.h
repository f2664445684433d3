// Getting up from the ground.
#pragma once

#include <array>

#include "robot/nao/guardian/key_frames.h"

namespace robot::nao {

/// The side of a robot that is down.
enum class Lying { on_back, on_front, on_left, on_right };

/// Returns the side that is down, from roll and pitch of the torso [rad] of a robot that lies.
Lying lying(const std::array<float, 2>& angles);

/// The joints that get a robot up: both arms, the hips' common joint, both legs.
inline constexpr std::array kGetUpJoints = {
    l_shoulder_pitch, l_shoulder_roll, l_elbow_yaw,  l_elbow_roll,  r_shoulder_pitch, r_shoulder_roll, r_elbow_yaw,
    r_elbow_roll,     l_hip_yaw_pitch, l_hip_roll,   l_hip_pitch,   l_knee_pitch,     l_ankle_pitch,   l_ankle_roll,
    r_hip_roll,       r_hip_pitch,     r_knee_pitch, r_ankle_pitch, r_ankle_roll};

/// Returns the motion of a robot that lies there. From the back it ends in the stand. From elsewhere it ends on the back:
/// such a robot rolls over first.
///
/// The way up is that of HULKs (github.com/HULKs/hulk, etc/motions/stand_up_back.json): sit up with the arms behind the body,
/// pull one foot under it, push with the other leg. From the seat on, the search began at their angles. Rolling over and
/// sitting up are our own. All were searched on simulated robots (tests/walk/tune_get_up.cpp). No real robot has played them.
KeyFrames get_up(Lying lying);

}  // namespace robot::nao
