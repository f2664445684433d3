// The joints of both legs: those of the walk, in LoLA's order.
#pragma once

#include <array>
#include <cstddef>

#include "robot/nao/lola/joints.h"
#include "robot/nao/walk/legs.h"

namespace robot::nao {

/// By side and joint of the walk. One motor turns both hip_yaw_pitch joints.
inline constexpr std::array<std::array<Joint, walk::kLegJoints>, 2> kLegJointsOf = {{
    {l_hip_yaw_pitch, l_hip_roll, l_hip_pitch, l_knee_pitch, l_ankle_pitch, l_ankle_roll},
    {l_hip_yaw_pitch, r_hip_roll, r_hip_pitch, r_knee_pitch, r_ankle_pitch, r_ankle_roll},
}};

/// Calls see(side, joint, name) for each joint of both legs.
template <class See>
void for_each_leg_joint(See&& see) {
  for (const walk::Side side : {walk::left, walk::right})
    for (std::size_t joint = 0; joint < walk::kLegJoints; ++joint) see(side, joint, kLegJointsOf[side][joint]);
}

/// Returns the legs among these positions [rad].
inline walk::Legs legs_of(const PerJoint<float>& positions) {
  walk::Legs legs{};
  for_each_leg_joint([&](walk::Side side, std::size_t joint, Joint name) { legs[side][joint] = positions[name]; });
  return legs;
}

/// Writes the legs into positions [rad]. The other joints keep theirs.
inline void put_legs(const walk::Legs& legs, PerJoint<float>& positions) {
  for_each_leg_joint(
      [&](walk::Side side, std::size_t joint, Joint name) { positions[name] = static_cast<float>(legs[side][joint]); });
}

}  // namespace robot::nao
