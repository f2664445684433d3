// The offset between the clocks of a robot and of the ground truth, found from what both recorded of one game.
#pragma once

#include <string>

#include "robot/core/result.h"
#include "robot/lab/clocks/clock_offset.h"
#include "robot/lab/clocks/data_offset.h"
#include "robot/lab/clocks/own_path.h"

namespace robot::lab {

/// The offset of a robot's clock to that of the truth. Times are those of both records.
struct TruthOffset {
  DataOffset clock;
  std::string by;  // "the ball and its pose, as 14/2 of the truth (by its number)", "the start gesture"
};

/// Standard deviations of an interval that covers 95 %.
inline constexpr double kTwoSided = 1.96;

/// Returns the offset in the middle of the recording, with an error that covers 95 %.
ClockOffset to_clock_offset(const DataOffset& clock);

/// Formats a measured drift: "12.0 ppm (± 1.3 ppm)", or "not significant: …". Empty if the drift was not measured.
std::string drift_text(const DataOffset& clock);

/// Finds the offset in `range` from the motion of the ball. If that is not certain, a start gesture in both records narrows
/// the search; it is the offset itself if the rest of the recording still does not tell it. Returns an Error with the reason if the data do not tell the offset.
Result<TruthOffset> offset_from_data(const TruthRecord& truth, const RobotRecord& robot, const LagRange& range);

}  // namespace robot::lab
