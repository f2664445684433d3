// The goals of a field, which are no robots.
#pragma once

#include "robot/truth/detection/ground_grid.h"
#include "robot/truth/detection/sight.h"
#include "sim/field/field.h"

namespace robot::truth {

/// Removes posts and crossbars from the grid, within twice the noise of the sensor. A robot below a crossbar stays. A net is
/// not removed: learn the background.
void remove_goals(const sim::field::Field& field, const Sight& sight, GroundGrid& grid);

}  // namespace robot::truth
