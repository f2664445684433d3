#include <cstdint>

#include "sim/world/contact.h"
#include "sim/world/touch.h"

namespace sim {
namespace {

// [s/m] Velocities are summed as whole numbers of 1 / kSpeedUnits, so that the sum does not depend on the order.
constexpr float kSpeedUnits = 0x1p20f;

/// The sum of the velocities at which others close in on a robot. [field]
struct Sum {
  std::int32_t x = 0, y = 0;

  void add(Vec2 velocity) {
    x += static_cast<std::int32_t>(velocity.x * kSpeedUnits);
    y += static_cast<std::int32_t>(velocity.y * kSpeedUnits);
  }
  Vec2 velocity() const {
    return {static_cast<float>(x) * (1 / kSpeedUnits), static_cast<float>(y) * (1 / kSpeedUnits)};
  }
};

}  // namespace

AllCollisions collisions_of(const ContactModel& contact, const World& world) {
  Sum sums[kMaxRobots];
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
      if (speed <= 0) return;
      sums[one].add(-speed * line);
      sums[another].add(speed * line);
    });
  });
  AllCollisions all;
  for_each_robot(world.players, [&](int robot) {
    all.closing[robot] = turned_back(sums[robot].velocity(), world.bodies[robot].facing);
  });
  return all;
}

}  // namespace sim
