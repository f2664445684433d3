// Windows with known figures.
#pragma once

#include <functional>

#include "sim/statistics/window.h"

namespace tests {

/// Returns a path whose ball is at `place(seconds)` [m, field] in each frame.
sim::statistics::Path path_of(double seconds, const std::function<std::optional<sim::Vec2>(double)>& place);

/// Returns a robot that is at `place(seconds)` in each frame.
sim::statistics::Robot robot_of(int side, int player, double seconds,
                                const std::function<std::optional<sim::statistics::Sighting>(double)>& place);

/// Returns a minute of a small game: a ball that is kicked now and then, three robots a side, one of which falls.
sim::statistics::Window small_game();

/// Adds noise of that standard deviation [m] along each axis. It depends on nothing else than the frames.
sim::statistics::Window with_noise(sim::statistics::Window window, float deviation);

}  // namespace tests
