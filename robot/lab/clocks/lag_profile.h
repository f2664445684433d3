// The agreement of a robot's distances with the ground truth, for every lag between their clocks.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "robot/lab/clocks/robust_line.h"
#include "robot/lab/clocks/shared_distance.h"

namespace robot::lab {

/// Lags in equal steps.
struct Lags {
  double first = 0, step = 0.02;  // [s]
  std::size_t count = 1;

  double at(std::size_t i) const { return first + static_cast<double>(i) * step; }

  /// Returns the lags from `middle - reach` to `middle + reach`, or a little further.
  static Lags around(double middle, double reach, double step);
};

/// Stretches of a robot's time, which a bootstrap draws. Time without a value belongs to none.
class Cells {
 public:
  /// Makes cells of `length` [s] for a series that is tidied. If these are more than `most`, cells are joined.
  Cells(const Series& series, double length, std::size_t most);

  std::size_t count() const { return starts_.size(); }

  /// Returns the cell of a time of the series [s].
  std::size_t of(double at) const;

 private:
  std::vector<double> starts_;  // [s] ascending
};

/// The gain of each lag: the log likelihood by which the truth explains the robot's distances better than one constant
/// distance does. It is kept by cells, so that the gains of a bootstrap sample need no further look at the distances.
class LagProfile {
 public:
  /// Compares a distance at all lags. With Everywhere::yes only values with a truth at every lag count, so that all lags
  /// explain the same values.
  enum class Everywhere { no, yes };
  LagProfile(const SharedDistance& distance, const Lags& lags, Cells cells, Everywhere everywhere);

  /// Returns the gain of each lag when each cell counts `times` times. A lag whose line has an unlikely slope has none.
  std::vector<double> gains(const std::vector<double>& times) const;

  /// Returns the gain of each lag when each cell counts once.
  std::vector<double> gains() const { return gains(std::vector<double>(cells_.count(), 1)); }

  /// Returns the number of values with a truth, at the lag that has most of them.
  std::size_t values() const { return values_; }

  const Lags& lags() const { return lags_; }
  const Cells& cells() const { return cells_; }

 private:
  void add(const SharedDistance& distance);

  const Lags lags_;
  const Cells cells_;
  std::vector<LossSums> sums_;  // by lag and cell
  std::size_t values_ = 0;
};

/// Returns the lag [s] of the greatest gain, between the lags of the profile. Returns nothing if it is at the border, or if
/// no lag has a gain.
std::optional<double> best_lag(const Lags& lags, const std::vector<double>& gains);

}  // namespace robot::lab
