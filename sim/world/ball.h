// The ball, as it truly is.
#pragma once

#include "sim/math/vec2.h"

namespace sim {

/// Frame: field.
struct Ball {
  Vec2 position;      // [m] centre
  Vec2 velocity;      // [m/s]
  Vec2 acceleration;  // [m/s²] in the last step
  // [m] where it was in the last ticks, newest first: what a camera with latency shows
  static constexpr int kPast = 4;
  Vec2 past[kPast];
};

/// Rolls the ball for `dt` [s] on turf that slows it by `deceleration` [m/s²], both >= 0; below `stop_speed` [m/s] it
/// lies still at once.
///
/// Exact, so the step size does not change the path: one long roll ends where many short ones do.
void roll(Ball& ball, float deceleration, float stop_speed, float dt);

/// Where the ball comes to rest if nobody touches it. [m, field]
Vec2 resting_place(const Ball& ball, float deceleration);

/// [m/s] at which a ball must start to roll `range` [m] far.
float speed_for_range(float range, float deceleration);

}  // namespace sim
