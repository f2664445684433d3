// Who does what in the team: each robot decides for itself, from what it believes of the others.
#pragma once

#include "sim/agent/view.h"

namespace sim::agent {

inline constexpr int kRoleCount = 4;
/// "keeper", "chaser", "supporter", "defender".
const char* name_of(Role role);

/// [s] the robot needs until it stands behind the ball; smooth and quick to compute, for comparing robots: the way,
/// half a turn where it looks away, half a circle round the ball where it stands on the wrong side.
float time_to_ball(const View& view);

/// Player 1 keeps the goal. Who is at the ball first chases it, and stays the chaser until another is quicker by the
/// hysteresis; of the rest, those farthest back defend and the others support. Robots that believe the same agree.
///
/// Mind.slot tells the lane among the robots of the same role, from right to left: `kMiddleLane` in the middle, two
/// apart from the next; `lane_of` gives it as a number that is 0 in the middle and 1 apart.
void assign_role(const View& view, Mind& mind);
inline constexpr Tick kSettle = 6;  // [ticks] from one such look at the team to the next
inline constexpr int kMiddleLane = 8;
constexpr float lane_of(const Mind& mind) { return 0.5f * static_cast<float>(int{mind.slot} - kMiddleLane); }

}  // namespace sim::agent
