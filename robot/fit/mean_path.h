// Means over parts of a path of the truth.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "robot/lab/clocks/truth_record.h"

namespace robot::fit {

/// A path whose means over any time are known at once. Places that are not finite, or farther than 100 m away, are left out.
class MeanPath {
 public:
  explicit MeanPath(const lab::Path& path);

  /// The mean of the places in an interval of time.
  struct Mean {
    double at = 0;         // [s]
    double x = 0, y = 0;   // [m, field]
    double heading = NAN;  // [rad, field]; NaN without a heading
    std::size_t places = 0;
  };
  /// Returns the mean over the closed interval [s], or nothing without a place in it.
  std::optional<Mean> over(double from, double to) const;

  /// Returns the velocity [m/s, field]: the slope of straight lines through the places of the interval. Its deviation is that for
  /// places with an error of 1 m. Returns nothing from fewer than four places.
  struct Slope {
    double x = 0, y = 0, deviation = 0;
  };
  std::optional<Slope> slope_over(double from, double to) const;

  const std::vector<lab::PlaceAt>& places() const { return places_; }
  std::size_t left_out() const { return left_out_; }

 private:
  /// Sums over all places before one.
  struct Sums {
    double at = 0, x = 0, y = 0, cos = 0, sin = 0;
  };
  std::size_t first_from(double at) const;

  std::vector<lab::PlaceAt> places_;
  std::vector<Sums> sums_;  // one more than places
  std::size_t left_out_ = 0;
};

}  // namespace robot::fit
