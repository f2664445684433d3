// The things that a synthetic sensor sees of a simulated game.
#pragma once

#include "robot/truth/synthetic/scene.h"
#include "sim/world/world.h"

namespace robot::app {

/// Returns the scene of a world. `ball_radius` [m] is that of the game's ball. Robots that the referee has removed are not
/// in it. A walking robot has strides, by the length of its way. The referee walks where the game has one, otherwise
/// back and forth behind the touch line at y > 0 of a field of `width` [m].
truth::Scene scene_of(const sim::World& world, double ball_radius, double width);

}  // namespace robot::app
