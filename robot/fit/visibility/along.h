// The true place of a thing at moments that follow each other.
#pragma once

#include <cstddef>
#include <optional>

#include "robot/lab/clocks/truth_record.h"

namespace robot::fit {

/// A path that is read at increasing times: much faster than a search for each moment. Other orders give the same places.
class Along {
 public:
  /// `path` outlives this. A thing that seems faster than `fastest` [m/s] was put elsewhere.
  Along(const lab::Path& path, double fastest) : path_(&path), fastest_(fastest) {}

  /// Returns the interpolated place at a moment [s], also of the heading. Returns nothing within a pause of more than
  /// SmoothCurve::kLongestGap, and where the thing was put elsewhere.
  std::optional<lab::PlaceAt> at(double seconds);

 private:
  const lab::Path* path_;
  double fastest_;
  std::size_t next_ = 0;  // the first place that is not before the last moment
};

}  // namespace robot::fit
