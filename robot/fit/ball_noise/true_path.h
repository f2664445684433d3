// Places of the truth at any moment, as curves through the places around it: they have less noise than a single one.
#pragma once

#include <optional>

#include "robot/lab/clocks/truth_record.h"

namespace robot::fit {

/// The shape of the curve, and the time over which it goes.
struct CurveShape {
  double half_window = 0.1;  // [s] to either side; more if the truth has fewer than 30 places a second
  bool bends = false;        // a parabola, else a straight line
};

/// A ball that rolls freely: friction bends its curve.
inline constexpr CurveShape kBallCurve{.half_window = 0.25, .bends = true};
/// A robot that walks and turns: its speed changes with each step. Straight lines would be ahead of one that begins
/// to turn.
inline constexpr CurveShape kRobotCurve{.half_window = 0.12, .bends = true};

/// A path as such curves. Refers to the path, which must outlive it.
class TruePath {
 public:
  TruePath(const lab::Path& path, const CurveShape& shape);

  struct Moment {
    double x = 0, y = 0;              // [m, field]
    double speed_x = 0, speed_y = 0;  // [m/s]
    double heading = 0;               // [rad, field]; NaN where the truth has none
    double turn_rate = 0;             // [rad/s]
    double bend = 0;                  // [m/s²] length of the acceleration; 0 for a straight line
    double share = 1;                 // variance of a value, in variances of a single place
    double rate_deviation = 0;        // [1/s] deviation of a rate, in deviations of a single place
    double scatter = 0;               // [m] deviation of the places from the curve, of each coordinate
  };

  /// Returns the moment [s], or nothing where places are missing on either side.
  std::optional<Moment> at(double seconds) const;

 private:
  const lab::Path& path_;
  CurveShape shape_;
};

/// Returns the standard deviation of the noise that differs from place to place, by the third differences of
/// successive ones: motion has nearly none. 0 with fewer than 50.
double scatter_of_places(const lab::Path& path);
/// Returns the same of the headings [rad], over all places that `counts`, by index; NaN where the truth has no
/// headings.
double scatter_of_headings(const lab::Path& path, const std::vector<bool>& counts);

/// The error of a place of the truth, in its parts.
struct TruthError {
  double scatter = 0;  // [m] differs from place to place, so a curve through several reduces it
  double shared = 0;   // [m] the same for all places of a moment: no curve reduces it

  /// Returns the variance [m²] of each coordinate of a moment.
  double variance(const TruePath::Moment& moment) const { return scatter * scatter * moment.share + shared * shared; }
};

/// Splits a whole deviation [m] into its parts. A truth without any scatter of the ball is that of a simulated game:
/// it is exact.
TruthError truth_error(double deviation, double scatter, double scatter_of_ball);

}  // namespace robot::fit
