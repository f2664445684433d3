#include "sim/motion/squat.h"

#include <algorithm>

namespace sim::motion {

void begin_squat(Tick now, Body& body) {
  body.doing = Body::Doing::crouching;
  body.since = now;
  body.velocity = {};
  body.turn_rate = 0;
}

Tick squat(const MotionParams& params, Tick now, Tick left, Body& body) {
  const Squat& model = params.model.squat;
  const bool going_down = body.doing == Body::Doing::crouching;
  const Tick end = body.since + std::max<Tick>(1, ticks(going_down ? model.delay : model.duration));
  const Tick used = end > now ? end - now : 1;
  if (used > left) return left;
  body.doing = going_down ? Body::Doing::squatting : Body::Doing::standing;
  if (!going_down) body.since = now + used;
  return used;
}

}  // namespace sim::motion
