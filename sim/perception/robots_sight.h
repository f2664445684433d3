// A robot's percepts of its opponents.
#pragma once

#include <span>

#include "sim/perception/look.h"
#include "sim/perception/perception.h"

namespace sim::perception {

inline constexpr Tick kGlance = 5;  // [ticks] between two looks for opponents, which are slow

/// Looks for one opponent in every fifth image, in turn, or once per call if calls are rarer. Without `limited_view` it
/// looks for all of them in each call.
///
/// Stores the opponent's believed place in `team_field`, which depends on the robot's believed pose. `missed_ball` and
/// `ball_noise` act as for the ball. Robots do not hide each other here: opponents matter as obstacles, and one behind
/// another is no obstacle.
void look_for_opponents(const PerceptionParams& params, std::span<const Look> looks);

}  // namespace sim::perception
