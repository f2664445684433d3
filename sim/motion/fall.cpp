#include "sim/motion/fall.h"

#include <algorithm>

namespace sim::motion {

void perhaps_fall(const MotionParams& params, int robot, Tick now, Tick steps, World& world) {
  Body& body = world.bodies[robot];
  float rate = 0;  // [1/s]
  if (body.doing == Body::Doing::walking) rate += params.model.falls.per_minute_walking / 60;
  if (body.touching > 0) rate += params.model.falls.per_second_touching;
  if (rate == 0) return;

  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::fall, now);
  if (uniform(words[0]) >= rate * static_cast<float>(steps) * kTickDuration) return;
  body.doing = Body::Doing::fallen;
  body.since = now;
  body.velocity = {};
  body.turn_rate = 0;
}

Tick lie(const MotionParams& params, int robot, Tick now, Tick left, World& world) {
  Body& body = world.bodies[robot];
  const Falls& falls = params.model.falls;

  // nothing changes within these ticks
  const bool fallen = body.doing == Body::Doing::fallen;
  const Tick duration = std::max<Tick>(1, ticks(fallen ? falls.lying : falls.getting_up));
  const Tick elapsed = std::min(now - body.since, duration - 1);
  if (elapsed + left < duration) return left;

  const Tick used = duration - elapsed;
  body.since = now + used;
  if (fallen) {
    body.doing = Body::Doing::getting_up;
    return used;
  }
  const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::get_up, body.since);
  body.doing = uniform(words[0]) < falls.failure ? Body::Doing::fallen : Body::Doing::standing;
  return used;
}

}  // namespace sim::motion
