// The offset of a robot's clock as a line in time, found from the distance of the ball.
#pragma once

#include <cmath>
#include <vector>

#include "robot/core/result.h"
#include "robot/lab/clocks/lag_search.h"
#include "robot/lab/clocks/shared_distance.h"

namespace robot::lab {

/// The offset of a robot's clock. Its times are by that clock, [s] since the epoch of
/// the distances.
struct DataOffset {
  double offset = 0;           // [s] at `middle`; > 0: the robot's clock is ahead
  double deviation = 0;        // [s] one standard deviation at `middle`
  double middle = 0;           // [s]
  double drift = 0;            // [s/s] growth of the offset
  double drift_deviation = 0;  // [s/s] one standard deviation; 0: the drift was not measured

  /// Reports whether the drift is significant. Otherwise it is not applied.
  bool drifts() const { return drift_deviation > 0 && std::abs(drift) > 3 * drift_deviation; }

  /// Returns the offset [s] at a time.
  double at(double seconds) const { return offset + (drifts() ? drift * (seconds - middle) : 0); }

  /// Returns one standard deviation [s] of the offset at a time.
  double deviation_at(double seconds) const { return std::hypot(deviation, drift_deviation * (seconds - middle)); }
};

/// Finds the offset in `range`. If three parts of two minutes or more tell it, it is the line through their offsets, with
/// the drift. Returns an Error as find_coarse_lag() and refined_lag() do.
Result<DataOffset> find_offset(const SharedDistance& distance, const LagRange& range);

/// One part's offset.
struct PartOffset {
  double middle = 0;  // [s]
  Lag lag;
};

/// Returns the line through the offsets of at least three parts, weighted by their deviations. Deviations that are too small
/// for the scatter of the parts are increased.
DataOffset line_through(const std::vector<PartOffset>& parts);

}  // namespace robot::lab
