// The ball, as it truly is.
#pragma once

#include "sim/math/vec2.h"

namespace sim {

/// Frame: field.
struct Ball {
  Vec2 position;      // [m] centre
  Vec2 velocity;      // [m/s]
  Vec2 acceleration;  // [m/s²] by which it slows down now; 0 when it lies
  // [m] where it was before the last rolls, which the game does once a tick, newest first: what a camera with latency
  // shows
  static constexpr int kPast = 4;
  Vec2 past[kPast];
};

/// Rolls the ball for `dt` [s] on turf that slows it by `deceleration` [m/s²], both >= 0; below `stop_speed` [m/s] it
/// lies still at once. Where it was becomes the newest of its past places.
///
/// Exact, so the step size does not change the path: one long roll ends where many short ones do.
void roll(Ball& ball, float deceleration, float stop_speed, float dt);

/// Puts the ball down at `position` [m, field]: it lies, and its past places are there.
void place(Ball& ball, Vec2 position);

/// Where the ball comes to rest if nobody touches it [m, field], for deceleration > 0. It leaves out that the ball stops
/// at once below its stop speed, which shortens its way by stop_speed² / (2 deceleration): 0.2 mm.
Vec2 resting_place(const Ball& ball, float deceleration);

/// [m/s] at which a ball must start to roll `range` [m] far, both >= 0.
float speed_for_range(float range, float deceleration);

}  // namespace sim
