// A robot's percepts of its opponents.
#pragma once

#include "sim/perception/image.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// Looks for one opponent and stores its believed place in `team_field`, which depends on the robot's believed pose.
/// `missed_ball` and `ball_noise` act as for the ball. Robots do not hide each other here: opponents matter as
/// obstacles, and one behind another is none. `number` distinguishes the draws of one robot.
void look_for_opponent(const PerceptionParams& params, const World& world, int robot, int opponent,
                       std::uint32_t number, agent::Beliefs& beliefs);

inline constexpr Tick kGlance = 5;  // [ticks] between two looks for opponents, which are slow

/// Looks for one opponent in every fifth image, in turn, or once per call if calls are rarer. Without `limited_view` it
/// looks for all of them in each call.
inline void look_for_opponents(const PerceptionParams& params, const World& world, int robot, Tick steps,
                               agent::Beliefs& beliefs) {
  const int first = robot_of(other(side_of(robot)), 1);
  const auto players = static_cast<Tick>(world.players);
  if (!params.effects.limited_view) {
    for (Tick i = 0; i < players; ++i)
      look_for_opponent(params, world, robot, first + static_cast<int>(i), world.tick * kMaxPlayers + i, beliefs);
    return;
  }
  // the opponent whose turn came since the last call
  if (steps <= kGlance && world.tick % kGlance >= steps) return;
  const Tick turn = world.tick / (steps <= kGlance ? kGlance : steps);
  look_for_opponent(params, world, robot, first + static_cast<int>(turn % players), world.tick, beliefs);
}

}  // namespace sim::perception
