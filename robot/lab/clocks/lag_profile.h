// The agreement of a robot's values with the ground truth, for every lag between their clocks.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "robot/lab/clocks/robust_line.h"
#include "robot/lab/clocks/shared_quantity.h"

namespace robot::lab {

/// Lags in equal steps.
struct Lags {
  double first = 0, step = 0.02;  // [s]
  std::size_t count = 1;

  double at(std::size_t i) const { return first + static_cast<double>(i) * step; }

  /// Returns the lags from `middle - reach` to `middle + reach`, or a little further.
  static Lags around(double middle, double reach, double step);
};

/// Cells of equal length in the robot's time, which a bootstrap draws.
struct Cells {
  double start = 0, length = 0.5;  // [s]
  std::size_t count = 1;

  /// Returns the cell of a time [s]. Times outside belong to the first or last one.
  std::size_t of(double at) const;
};

/// The gain of each lag: the log likelihood by which the truth explains the robot's values better than one constant value
/// does. It is kept by cells, so that the gains of a bootstrap sample need no further look at the values.
class LagProfile {
 public:
  LagProfile(const Lags& lags, const Cells& cells) : lags_(lags), cells_(cells) {}

  /// Adds a quantity. `everywhere`: only values with a truth at every lag count, so that all lags explain the same values.
  void add(const SharedQuantity& quantity, bool everywhere);

  /// Returns the gain of each lag when each cell counts `times` times.
  std::vector<double> gains(const std::vector<double>& times) const;

  /// Returns the gain of each lag when each cell counts once.
  std::vector<double> gains() const { return gains(std::vector<double>(cells_.count, 1)); }

  /// Returns the number of values that count at a lag, of all quantities.
  std::size_t values(std::size_t lag) const { return values_[lag]; }

  const Lags& lags() const { return lags_; }
  const Cells& cells() const { return cells_; }

 private:
  /// The sums of one quantity, by lag and cell.
  struct Table {
    double least_slope, most_slope;
    std::vector<LossSums> sums;
  };

  const Lags lags_;
  const Cells cells_;
  std::vector<Table> tables_;
  std::vector<std::size_t> values_ = std::vector<std::size_t>(lags_.count);
};

/// Returns the lag [s] of the greatest gain, between the lags of the profile. Returns nothing if it is at the border, or if
/// no lag has a gain.
std::optional<double> best_lag(const Lags& lags, const std::vector<double>& gains);

}  // namespace robot::lab
