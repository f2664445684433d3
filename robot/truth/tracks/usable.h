// The check of detections before they change the scene.
#pragma once

#include <cstdint>

#include "robot/core/result.h"
#include "robot/truth/tracks/sensor.h"

namespace robot::truth {

/// Most robots of one image that are used.
constexpr std::size_t kMostSeenRobots = 32;

/// Returns an Error if the image has no capture time, or is of none of this many sensors.
Result<void> check_image(const SensorImage& image, std::size_t sensors);

/// Returns the detections that can be used, robots in an order that depends only on their places, so that the order in the
/// image does not matter. Adds the count of the others to `refused`.
///
/// Refused are places that are not finite or farther than 100 m, covariances that are not those of a place, and more robots
/// than kMostSeenRobots. A heading that is not finite is left out.
Detections usable(const Detections& detections, std::uint64_t& refused);

}  // namespace robot::truth
