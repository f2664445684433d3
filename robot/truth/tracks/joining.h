// Trails that an occlusion has broken become one again.
#pragma once

#include "robot/truth/tracks/trails.h"

namespace robot::truth {

/// A trail of a robot with the only player that it was ever identified as.
struct RobotTrail {
  Trail trail;
  std::optional<std::size_t> player;  // index; absent: none
  bool several_players = false;       // identified as different ones: the identity of each moment counts
};

/// Joins an ended trail with a later one where the robot can have walked there within 15 s, both are not two different
/// players, and neither fits to another trail. The joined trail keeps the earlier number.
/// The trails are in the order of their beginnings, before and after.
void join_broken(std::vector<RobotTrail>& trails, const std::vector<Sensor>& sensors);

}  // namespace robot::truth
