// The ball: ground truth.
#pragma once

#include "sim/math/vec2.h"

namespace sim {

/// The true state of the ball. Frame: field.
struct Ball {
  Vec2 position;      // [m] centre
  Vec2 velocity;      // [m/s]
  Vec2 acceleration;  // [m/s²] present slow-down; 0 at rest
  static constexpr int kPast = 4;
  Vec2 past
      [kPast];  // [m] positions before the last rolls, newest first, one roll a tick: a camera with latency sees these
};

/// Rolls the ball for `dt` [s] on turf that slows it by `deceleration` [m/s²], both >= 0. Below `stop_speed` [m/s] the
/// ball stops at once. Its former position becomes the newest of `past`.
///
/// Exact, so the step size does not change the path: one long roll ends where many short ones do.
void roll(Ball& ball, float deceleration, float stop_speed, float dt);

/// Puts the ball down at rest at `position` [m, field]; its past positions are there too.
void place(Ball& ball, Vec2 position);

/// Returns where the ball comes to rest if nobody touches it [m, field], for deceleration > 0. It ignores the stop
/// speed, which shortens the way by stop_speed² / (2 deceleration): 0.2 mm.
Vec2 resting_place(const Ball& ball, float deceleration);

/// Returns the speed [m/s] with which a ball must start in order to roll `range` [m], both >= 0.
float speed_for_range(float range, float deceleration);

}  // namespace sim
