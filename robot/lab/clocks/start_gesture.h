// The start gesture: the ball is lifted, or covered, three times. Ground truth and robot both see it vanish and return.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "robot/lab/clocks/lag_search.h"

namespace robot::lab {

/// Whether the ball was seen at one moment.
struct Sighting {
  double at = 0;  // [s]
  bool seen = false;
};

/// The six moments [s] of a gesture: the ball vanishes, returns, vanishes …
using Gesture = std::array<double, 6>;

/// Returns the gestures in a recording. The ball is away three times and back twice, for 0.3 to 4 s each. Before and after
/// that it is seen for a second or longer. Shorter absences are missed images.
std::vector<Gesture> gestures_in(std::vector<Sighting> sightings);

/// Returns the lag by which the robot's gesture is later than the truth's. Its deviation follows from the scatter of the six
/// moments. Returns nothing without a pair of gestures of the same rhythm, or if pairs contradict each other.
std::optional<Lag> gesture_lag(const std::vector<Gesture>& truth, const std::vector<Gesture>& robot,
                               const LagRange& range);

}  // namespace robot::lab
