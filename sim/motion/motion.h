// The motion controller: commands → bodies.
#pragma once

#include "sim/math/tick.h"
#include "sim/motion/command.h"
#include "sim/motion/model.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim::motion {

/// What moving depends on; none of it changes during a game.
struct Means {
  const Model& model;
  const Effects& effects;
  const BallModel& ball;
};

/// Moves one body `steps` ticks on, up to the tick after `world.tick + steps - 1`, as `command` says: walk, head, kick,
/// falling and getting up. A kick whose foot reaches the ball sets its velocity, `world.kicked` and `world.touched`;
/// one that misses sets `world.whiffed`. No body is ever faster than its model's speeds.
void move(const Means& means, const Command& command, int robot, Tick steps, World& world);

/// The kick of that name, or -1.
int find_kick(const Model& model, const char* name);

/// [s] that the body needs from where it stands to `target` [m, robot], turning to `heading` [rad, robot] on the way;
/// what agents and roles reckon with. Within 20 % of what walk_to then takes without noise.
float time_to_reach(const Walk& walk, Vec2 target, float heading);

}  // namespace sim::motion
