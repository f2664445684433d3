#include "sim/motion/head.h"

#include "sim/motion/batch.h"
#include "sim/motion/head_lanes.h"

namespace sim::motion {
namespace {

bool turns(const Mover& mover) {
  return mover.head_steps > 0 && mover.command->head != Command::Head::keep &&
         mover.world->bodies[mover.robot].doing < Body::Doing::fallen;
}

bool aims(const Command& command) { return command.head == Command::Head::look_to; }

Gaze gaze_of(const Body& body) { return {body.head_yaw, body.head_pitch, body.look}; }

void take(const Gaze& gaze, Body& body) {
  body.head_yaw = gaze.yaw, body.head_pitch = gaze.pitch, body.look = gaze.look;
}

float head_time(const Mover& mover) { return static_cast<float>(mover.head_steps) * kTickDuration; }

[[gnu::flatten]] void turn_one(const MotionParams& params, const Mover& mover) {
  const float(&look)[3] = mover.command->look;
  Body& body = mover.world->bodies[mover.robot];
  const Gaze gaze = gaze_of(body);
  Angles to{look[0], look[1]};
  if (aims(*mover.command)) {
    const Stand stand{body.position, body.heading, body.facing};
    to = aimed_at(seen_now({look[0], look[1]}, *mover.told, stand), look[2], gaze);
  }
  take(turned_to(params.model.head, params.effects.head_limits, to, head_time(mover), gaze), body);
}

void gather(const Mover& mover, int i, HeadLanes& lanes) {
  const Command& command = *mover.command;
  const Body& body = mover.world->bodies[mover.robot];
  lanes.aims[i] = aims(command) ? 1 : 0;
  lanes.aim.set(i, {command.look[0], command.look[1]}), lanes.height[i] = command.look[2];
  lanes.told.set(i, mover.told->position), lanes.told_heading[i] = mover.told->heading;
  lanes.position.set(i, body.position), lanes.heading[i] = body.heading, lanes.facing.set(i, body.facing);
  lanes.set_gaze(i, gaze_of(body));
  lanes.dt[i] = head_time(mover);
}

/// Turns up to kLanes heads.
void turn_some(const MotionParams& params, std::span<const Mover* const> movers) {
  if (!worth_lanes(movers.size())) {
    for (const Mover* const mover : movers) turn_one(params, *mover);
    return;
  }
  HeadLanes lanes;
  if (movers.size() < kLanes) lanes = {};
  const Head& head = params.model.head;
  for (std::size_t i = 0; i < movers.size(); ++i) gather(*movers[i], static_cast<int>(i), lanes);
  params.effects.head_limits ? in_lanes<turn_heads_on<true>>(head, lanes) : in_lanes<turn_heads_on<false>>(head, lanes);
  for (std::size_t i = 0; i < movers.size(); ++i)
    take(lanes.gaze(static_cast<int>(i)), movers[i]->world->bodies[movers[i]->robot]);
}

}  // namespace

void turn_head(const MotionParams& params, const Mover& mover) {
  if (turns(mover)) turn_one(params, mover);
}

void turn_heads(const MotionParams& params, std::span<const Mover> movers) {
  auto batch = batch_of<const Mover*>([&](std::span<const Mover*> some) {
    turn_some(params, some);
    return std::size_t{0};
  });
  for (const Mover& mover : movers)
    if (turns(mover)) batch.add(&mover);
  batch.finish();
}

}  // namespace sim::motion
