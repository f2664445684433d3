// One image of one sensor changes the ball of the scene.
#pragma once

#include "robot/truth/tracks/scene.h"

namespace robot::truth {

/// Takes the ball of an image into the scene. A ball at a place where the known one cannot be is another one, as soon as
/// three images show it and the known one is not seen.
void advance_ball(TrackScene& scene, const std::vector<Sensor>& sensors, const SensorImage& image);

}  // namespace robot::truth
