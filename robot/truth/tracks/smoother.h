// Ground truth after the game: a whole recording at once.
#pragma once

#include "robot/core/result.h"
#include "robot/truth/tracks/fusion.h"

namespace robot::truth {

/// Returns the truth at each image, in the order of their times.
///
/// Places and velocities are better than the tracker's, because the future counts as much as the past. A thing is in the
/// truth from the first image that shows it. A robot has its player from there on. Trails that an occlusion has broken are
/// one where that is unique. Memory grows with the recording, by about 2 kB for each measurement of the longest trail.
///
/// `images` and `poses` may be in any order. Images that repeat another one are left out. Returns an Error if a sensor
/// does not exist, an image has no time, an own pose is not valid, or there are too many sensors or players.
Result<std::vector<FusedTruth>> smooth(const std::vector<Sensor>& sensors, std::vector<SensorImage> images,
                                       std::vector<OwnPose> poses = {});

}  // namespace robot::truth
