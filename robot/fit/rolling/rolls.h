// Parts of a game in which the ball rolls freely, by the truth alone.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/lab/clocks/truth_record.h"

namespace robot::fit {

/// A free roll: no robot is near, and the ball neither turns nor becomes faster.
struct Roll {
  std::size_t recording = 0;  // index of the truth
  double at = 0;              // [s] of its begin, since the epoch of the truth
  double duration = 0;        // [s]
  double speed = 0;           // [m/s] at its begin
  double end_speed = 0;       // [m/s]
  double deceleration = 0;    // [m/s²] of the parabola through its places
  double deviation = 0;       // [m/s²] one standard deviation of that, by the scatter of the places
};

/// Returns the rolls of a game. A roll ends where a robot is within 0.35 m, where the ball is slower than 0.25 m/s, and where the
/// truth has a gap. It also ends where the ball turns by more than 10° or becomes faster, beyond the error of the truth. Rolls
/// shorter than 0.5 s are left out, and those whose places are no parabola.
std::vector<Roll> rolls_in(const lab::TruthRecord& truth, std::size_t recording);

}  // namespace robot::fit
