// How the turf slows the ball, from free rolls of the truth.
#pragma once

#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/fit/evidence.h"
#include "robot/fit/figure.h"
#include "robot/fit/rolling/rolls.h"

namespace robot::fit {

struct Rolling {
  std::vector<Roll> rolls;
  std::vector<std::string> recordings;  // names of those with a roll, by index
  Figure deceleration;                  // ball.deceleration [m/s²]
  double spread = 0;                    // [m/s²] standard deviation between rolls, beyond the error of each
  std::string kept;                     // the reason why ball.stop_speed stays as it is
};

/// Fits the deceleration. Each roll counts by its own error and the spread between rolls; single bad ones hardly count. The
/// interval covers the luck of rolls. Returns an Error with fewer than eight rolls.
Result<Rolling> fit_rolling(const Evidence& evidence);

/// Returns the rolls with their times, speeds and decelerations.
Table table_of(const Rolling& fit);

/// Formats the fit for a terminal, with the rolls drawn in characters.
std::string to_text(const Rolling& fit);

}  // namespace robot::fit
