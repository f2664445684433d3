// Measured quantities over time, and a smooth curve through one.
#pragma once

#include <optional>
#include <vector>

namespace robot::lab {

/// One value of a measured quantity.
struct Sample {
  double at = 0;     // [s] since an epoch that both sides share
  double value = 0;  // in the unit of the quantity
};

using Series = std::vector<Sample>;

/// Returns the middle one of the values, the upper one of two; 0 without any.
double median_of(std::vector<double> values);

/// Returns the finite samples in the order of their times. Of several samples at one time the first counts.
Series tidied(Series series);

/// A smooth curve through the samples of ground truth: a local parabola at each moment. Straight lines between 30 samples a
/// second would favour lags of half a frame (shared/facts/ground_truth.md section 5).
class SmoothCurve {
 public:
  SmoothCurve() = default;

  /// `series` is tidied.
  explicit SmoothCurve(const Series& series);

  /// Returns the value at a moment [s], or nothing where samples are missing for more than kLongestGap.
  std::optional<double> at(double seconds) const;

  /// Returns the change per second at a moment [s], or nothing where samples are missing.
  std::optional<double> rate_at(double seconds) const;

  static constexpr double kLongestGap = 0.25;  // [s]

 private:
  /// Values at equal distances in time, without a gap.
  struct Piece {
    double start = 0;  // [s]
    std::vector<double> values;
  };

  std::vector<Piece> pieces_;  // in the order of their times
};

}  // namespace robot::lab
