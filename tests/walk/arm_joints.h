// The joints of both arms: those of the physics, in LoLA's order.
#pragma once

#include "robot/nao/lola/joints.h"
#include "tests/walk/physics.h"

namespace robot::nao::walk {

/// By side and joint of the physics.
inline constexpr std::array<std::array<Joint, kArmJoints>, 2> kArmJointsOf = {{
    {l_shoulder_pitch, l_shoulder_roll, l_elbow_yaw, l_elbow_roll},
    {r_shoulder_pitch, r_shoulder_roll, r_elbow_yaw, r_elbow_roll},
}};

/// Returns the arms among these positions [rad].
inline Arms arms_of(const PerJoint<float>& positions) {
  Arms arms{};
  for (const Side side : {left, right})
    for (std::size_t joint = 0; joint < kArmJoints; ++joint) arms[side][joint] = positions[kArmJointsOf[side][joint]];
  return arms;
}

/// Writes the arms into positions [rad]. The other joints keep theirs.
inline void put_arms(const Arms& arms, PerJoint<float>& positions) {
  for (const Side side : {left, right})
    for (std::size_t joint = 0; joint < kArmJoints; ++joint)
      positions[kArmJointsOf[side][joint]] = static_cast<float>(arms[side][joint]);
}

}  // namespace robot::nao::walk
