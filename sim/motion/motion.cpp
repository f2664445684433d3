#include "sim/motion/motion.h"

#include "sim/motion/fall.h"
#include "sim/motion/kick.h"
#include "sim/motion/rhythm.h"
#include "sim/motion/squat.h"
#include "sim/motion/walk.h"

namespace sim::motion {

namespace {

/// Does everything but walking: falls, gets up, kicks, squats. Returns the number of ticks left for walking.
Tick anything_else(const MotionParams& params, const Command& command, int robot, Tick steps, World& world) {
  Body& body = world.bodies[robot];
  if (body.doing == Body::Doing::removed) return 0;
  if (params.effects.falls && !lies(body)) perhaps_fall(params, robot, world.tick, steps, world);

  // a kick or a squat begins at once, unless a walking step has to be finished first
  const bool kicks = command.body == Command::Body::kick && command.kick < params.model.kick_count;
  const bool free = !lies(body) && !squats(body) && body.doing != Body::Doing::kicking &&
                    !in_step(Rhythm(params.model.walk), body, world.tick);
  if (kicks && free) begin_kick(command, world.tick, body);
  if (command.body == Command::Body::squat && free) begin_squat(world.tick, body);

  // one thing after the other until the ticks are used up
  Tick left = steps;
  const auto now = [&] { return world.tick + steps - left; };
  while (left > 0 && lies(body)) left -= lie(params, robot, now(), left, world);
  while (left > 0 && squats(body)) left -= squat(params, now(), left, body);
  if (left > 0 && body.doing == Body::Doing::kicking) left -= kick(params, robot, now(), left, world);
  return left;
}

}  // namespace

void move(const MotionParams& params, const Command& command, int robot, Tick steps, World& world) {
  Body& body = world.bodies[robot];
  Tick left = steps;
  if (body.doing >= Body::Doing::kicking || command.body >= Command::Body::kick || params.effects.falls) {
    left = anything_else(params, command, robot, steps, world);
    if (left == 0) return;
  }
  const bool rests = body.doing == Body::Doing::standing && command.body == Command::Body::stand;
  if (!rests) walk(params, command, robot, world.tick + steps - left, left, world);
}

}  // namespace sim::motion
