// The roles in a team: each robot decides for itself, from its beliefs about the others.
#pragma once

#include "sim/agent/view.h"

namespace sim::agent {

inline constexpr int kRoleCount = 4;
/// "keeper", "chaser", "supporter", "defender".
const char* name_of(Role role);

/// Estimates the time [s] until the robot stands behind the ball. It adds up the way, up to half a turn to face the
/// ball, and up to half a circle round the ball. Smooth and quick to compute, for comparing robots.
float time_to_ball(const View& view);

/// Assigns the own role. Player 1 keeps the goal. The quickest robot chases the ball until another is quicker by the
/// hysteresis. Of two that both say that they chase, the one with the higher number leaves the ball to the other.
/// Otherwise both might leave it until their next messages. Of the rest, those farthest back defend and the others
/// support. Robots with equal beliefs agree.
///
/// Mind.slot is the lane among the robots of the same role, from right to left: `kMiddleLane` is the middle one, and
/// neighbours are 2 apart. `lane_of` returns it as a number: 0 is the middle, and neighbours are 1 apart.
void assign_role(const View& view, Mind& mind);
inline constexpr Tick kSettle = 6;  // [ticks] from one assignment to the next
inline constexpr int kMiddleLane = 8;
constexpr float lane_of(const Mind& mind) { return 0.5f * static_cast<float>(int{mind.slot} - kMiddleLane); }

}  // namespace sim::agent
