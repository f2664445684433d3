// The way of a ball past an opponent.
#pragma once

#include "sim/agent/view.h"

namespace sim::agent {

/// Returns the direction [robot, unit vector] in which to drive the ball instead of `way`: past the nearest opponent in
/// front of the ball, `room` [m] from its middle. From nearer than `room` the ball goes straight across, and comes no
/// nearer. It passes on the side of `way`, on the other one where that side is outside the field.
Vec2 past_nearest(const View& view, Vec2 way, float room);

}  // namespace sim::agent
