// What a robot sees of its opponents.
#pragma once

#include "sim/perception/image.h"
#include "sim/perception/perception.h"

namespace sim::perception {

/// Looks for one opponent and writes down where in `team_field` it believes it saw it: its own pose is a belief.
/// `missed_ball` and `ball_noise` act as for the ball. That robots hide each other is left out: they are obstacles, and
/// one behind another is none. `number` tells the looks of a robot apart.
void look_for_opponent(const PerceptionParams& params, const World& world, int robot, int opponent,
                       std::uint32_t number, agent::Beliefs& beliefs);

inline constexpr Tick kGlance = 5;  // [ticks] between two looks for opponents, who are slow

/// Looks for one opponent in each fifth image in turn, or in each image if they are rarer; without `limited_view` for
/// all in every image.
inline void look_for_opponents(const PerceptionParams& params, const World& world, int robot, Tick steps,
                               agent::Beliefs& beliefs) {
  const int first = robot_of(other(side_of(robot)), 1);
  const auto players = static_cast<Tick>(world.players);
  if (!params.effects.limited_view) {
    for (Tick i = 0; i < players; ++i)
      look_for_opponent(params, world, robot, first + static_cast<int>(i), world.tick * kMaxPlayers + i, beliefs);
    return;
  }
  // the number of the turn that came since the last image
  if (steps <= kGlance && world.tick % kGlance >= steps) return;
  const Tick turn = world.tick / (steps <= kGlance ? kGlance : steps);
  look_for_opponent(params, world, robot, first + static_cast<int>(turn % players), world.tick, beliefs);
}

}  // namespace sim::perception
