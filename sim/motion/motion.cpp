#include "sim/motion/motion.h"

#include "sim/motion/fall.h"
#include "sim/motion/head.h"
#include "sim/motion/kick.h"
#include "sim/motion/walk.h"

namespace sim::motion {

void move(const Means& means, const Command& command, int robot, Tick steps, World& world) {
  Body& body = world.bodies[robot];
  if (body.doing == Body::Doing::removed) return;

  if (means.effects.falls && !is_down(body)) perhaps_fall(means, robot, world.tick, steps, world);
  if (command.head != Command::Head::keep && !is_down(body)) turn_head(means, command, steps, body);

  const bool kicks = command.body == Command::Body::kick && command.kick < means.model.kick_count;
  if (kicks && !is_down(body) && body.doing != Body::Doing::kicking) begin_kick(command, world.tick, body);

  // one thing after the other until the ticks are used up
  Errand errand = errand_of(command);
  const Tick end = world.tick + steps;
  for (Tick now = world.tick; now < end;) {
    const Tick left = end - now;
    if (is_down(body)) {
      now += lie(means, robot, now, left, world);
    } else if (body.doing == Body::Doing::kicking) {
      now += kick(means, robot, now, left, world);
    } else {
      now += walk(means, command, robot, now, left, errand, world);
    }
  }
}

}  // namespace sim::motion
