// A first pose of a sensor, without a guess.
#pragma once

#include <optional>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/calibration/fit.h"

namespace robot::truth {

/// Returns a view near the true one, from which a fit finds it, also when some sightings are wrong. It computes many poses,
/// each from a few sightings, and returns the one that most sightings agree with. With `ground` two sightings give a pose (their rays meet the
/// plane), otherwise four (a homography). The sensor is above the carpet. Returns an Error if no pose exists, or if the
/// sightings fit a mirrored field far better.
Result<View> start_view(const std::vector<Sighting>& sightings, const Projection& camera,
                        const std::optional<Ground>& ground);

}  // namespace robot::truth
