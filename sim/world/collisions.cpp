#include "sim/world/contact.h"
#include "sim/world/touch.h"

namespace sim {
namespace {

/// Keeps the collision if it is harder than the others of that robot.
void note(const Body& body, float speed, Vec2 direction, Collision& hardest) {
  if (speed > hardest.speed) hardest = {speed, turned_back(direction, body.facing)};
}

}  // namespace

AllCollisions collisions_of(const ContactModel& contact, const World& world) {
  AllCollisions all;
  for_each_robot(world.players, [&](int one) {
    const Body& body = world.bodies[one];
    if (body.touching == 0) return;
    for_each_robot(world.players, [&](int another) {
      const Body& other = world.bodies[another];
      if (another <= one || other.touching == 0 || (body.touching > 1 && other.touching > 1)) return;
      const Vec2 apart = other.position - body.position;
      const float gap = length(apart), reach = radius_of(contact, body) + radius_of(contact, other) + kTouch;
      if (gap == 0 || gap >= reach) return;
      const Vec2 line = (1 / gap) * apart;
      const float speed = dot(turned(body.velocity, body.facing) - turned(other.velocity, other.facing), line);
      note(body, speed, -line, all.of[one]);
      note(other, speed, line, all.of[another]);
    });
  });
  return all;
}

}  // namespace sim
