#include "sim/motion/motion.h"

#include "sim/math/lanes.h"
#include "sim/motion/fall.h"
#include "sim/motion/head.h"
#include "sim/motion/kick.h"
#include "sim/motion/rhythm.h"
#include "sim/motion/squat.h"
#include "sim/motion/walk.h"

namespace sim::motion {

namespace {

/// Does everything but walking: falls, gets up, kicks, squats. Returns the number of ticks left for walking.
Tick anything_else(const MotionParams& params, const Mover& mover) {
  const auto& [command, told, world, robot, steps, head_steps] = mover;
  Body& body = world->bodies[robot];
  if (body.doing == Body::Doing::removed) return 0;
  if (params.effects.falls && !lies(body)) perhaps_fall(params, robot, world->tick, steps, *world);

  // a kick or a squat begins at once, unless a walking step has to be finished first
  const bool kicks = command->body == Command::Body::kick && command->kick < params.model.kick_count;
  const bool squat_now = command->body == Command::Body::squat;
  if ((kicks || squat_now) && !lies(body) && !squats(body) && body.doing != Body::Doing::kicking &&
      !in_step(Rhythm(params.model.walk), body, world->tick)) {
    if (kicks) begin_kick(*command, world->tick, body);
    if (squat_now) begin_squat(world->tick, body);
  }

  // one thing after the other until the ticks are used up
  Tick left = steps;
  const auto now = [&, world = world, steps = steps] { return world->tick + steps - left; };
  while (left > 0 && lies(body)) left -= lie(params, robot, now(), left, *world);
  while (left > 0 && squats(body)) left -= squat(params, now(), left, body);
  if (left > 0 && body.doing == Body::Doing::kicking) left -= kick(params, robot, now(), left, *world);
  return left;
}

bool rests(const Mover& mover) {
  return mover.world->bodies[mover.robot].doing == Body::Doing::standing &&
         mover.command->body == Command::Body::stand;
}

}  // namespace

void move(const MotionParams& params, std::span<const Mover> movers) {
  // kicks change the ball, so all that is not walking happens in the order of the list
  Walker walkers[kLanes];
  std::size_t count = 0;
  for (const Mover& mover : movers) {
    const Tick left = anything_else(params, mover);
    if (left == 0 || rests(mover)) continue;
    walkers[count++] = {mover.command, mover.world, mover.robot, mover.world->tick + mover.steps - left, left,
                        errand_of(*mover.command)};
    if (count == kLanes) walk(params, {walkers, count});
    count %= kLanes;
  }
  if (count > 0) walk(params, {walkers, count});
  turn_heads(params, movers);
}

}  // namespace sim::motion
