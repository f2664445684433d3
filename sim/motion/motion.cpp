#include "sim/motion/motion.h"

#include "sim/motion/batch.h"
#include "sim/motion/fall.h"
#include "sim/motion/head.h"
#include "sim/motion/kick.h"
#include "sim/motion/rhythm.h"
#include "sim/motion/squat.h"
#include "sim/motion/walk.h"

namespace sim::motion {

namespace {

/// Begins a kick or a squat that is commanded: at once, unless a walking step has to be finished first.
void perhaps_begin(const MotionParams& params, const Command& command, Tick now, Body& body) {
  const bool kicks = command.body == Command::Body::kick && command.kick < params.model.kick_count;
  const bool down = command.body == Command::Body::squat;
  if (!kicks && !down) return;
  if (body.doing >= Body::Doing::kicking || in_step(Rhythm(params.model.walk), body, now)) return;
  kicks ? begin_kick(command, now, body) : begin_squat(now, body);
}

/// Does everything but walking: lies, gets up, kicks, squats. Returns the number of ticks left for walking.
Tick anything_else(const MotionParams& params, const Mover& mover) {
  World& world = *mover.world;
  const int robot = mover.robot;
  Body& body = world.bodies[robot];
  if (!on_field(body)) return 0;
  if (mover.command->body >= Command::Body::kick) perhaps_begin(params, *mover.command, world.tick, body);
  if (body.doing < Body::Doing::kicking) return mover.steps;

  // one thing after the other until the ticks are used up
  Tick left = mover.steps;
  const auto now = [&] { return world.tick + mover.steps - left; };
  while (left > 0 && lies(body)) left -= lie(params, robot, now(), left, world);
  while (left > 0 && squats(body)) left -= squat(params, now(), left, body);
  if (left > 0 && body.doing == Body::Doing::kicking) left -= kick(params, robot, now(), left, world);
  return left;
}

bool rests(const Mover& mover) {
  return mover.world->bodies[mover.robot].doing == Body::Doing::standing && mover.command->body == Command::Body::stand;
}

Walker walker_of(const Mover& mover, Tick left) {
  return {
      mover.command, mover.world, mover.robot, mover.world->tick + mover.steps - left, left, errand_of(*mover.command)};
}

void move_alone(const MotionParams& params, const Mover& mover) {
  if (params.effects.falls) perhaps_fall(params, mover);
  const Tick left = anything_else(params, mover);
  if (left > 0 && !rests(mover)) walk_alone(params, walker_of(mover, left));
  turn_head(params, mover);
}

}  // namespace

void move(const MotionParams& params, std::span<const Mover> movers) {
  if (!worth_lanes(movers.size())) {
    for (const Mover& mover : movers) move_alone(params, mover);
    return;
  }
  if (params.effects.falls) perhaps_fall(params, movers);

  // kicks change the ball, so all that is not walking happens in the order of the list
  auto walkers = batch_of<Walker>([&](std::span<Walker> some) { return walk_together(params, some); });
  for (const Mover& mover : movers) {
    const Tick left = anything_else(params, mover);
    if (left > 0 && !rests(mover)) walkers.add(walker_of(mover, left));
  }
  walkers.finish();
  turn_heads(params, movers);
}

}  // namespace sim::motion
