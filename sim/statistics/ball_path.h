// The ball's path, its speed, and the kicks in it.
#pragma once

#include <optional>
#include <vector>

#include "sim/statistics/window.h"

namespace sim::statistics {

/// Returns the path with gaps of up to 0.35 s filled linearly, and each place replaced by the median of the seven frames
/// around it. Longer gaps stay.
Path smoothed(const Path& seen);

/// Speed of the ball in each frame [m/s]: its displacement over the next 0.2 s. Absent without a ball, and above 4 m/s,
/// where a hand or a wrong box moved it.
using Speeds = std::vector<std::optional<double>>;
Speeds speeds_of(const Path& smooth);

/// A kick, or a push of the same strength.
struct Kick {
  std::size_t frame = 0;       // at which it begins
  double speed = 0;            // [m/s] the peak
  std::optional<double> roll;  // [m] from its beginning until the ball is slower than 0.1 m/s; absent: not seen
};

/// Returns the kicks in order. A kick is a peak above 0.5 m/s within 0.6 s. It is more than twice the median speed of
/// 0.1 to 0.6 s before it.
std::vector<Kick> kicks_in(const Path& smooth, const Speeds& speeds);

/// Returns the share of the frames with a ball in which it rests for more than `seconds`. It rests while it stays within
/// 0.15 m of one place. Frames without a ball do not end a rest. (A limit of its speed would end rests by noise.)
double share_at_rest(const Path& smooth, double seconds);

/// Returns the median displacement [m] after `seconds`.
double displacement_after(const Path& smooth, double seconds);

}  // namespace sim::statistics
