// The likelihood of one parameter on a grid, kept for each event: a sample of events is fitted by adding rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "robot/fit/math/resampling.h"

namespace robot::fit {

/// Returns the median, that of an even number being the mean of the middle two; 0 without any. The upper one of two
/// would bias the errors of short passes.
double middle_of(std::vector<double> values);

/// The costs of events at some values of a parameter. A cost is minus the logarithm of a likelihood.
class Profile {
 public:
  /// `value_at` returns the value at a place of the grid, 0 .. `size` - 1, also between two; `size` >= 3.
  Profile(std::size_t size, std::function<double(double place)> value_at) : value_at_(std::move(value_at)) {
    for (std::size_t i = 0; i < size; ++i) values_.push_back(value_at_(static_cast<double>(i)));
  }

  std::size_t events() const { return costs_.size() / values_.size(); }

  void begin_event() { costs_.resize(costs_.size() + values_.size()); }

  /// Adds one observation to the newest event: `cost` of a value.
  template <class Cost>
  void add(Cost&& cost) {
    double* const row = &costs_[costs_.size() - values_.size()];
    for (std::size_t i = 0; i < values_.size(); ++i) row[i] += cost(values_[i]);
  }

  /// Returns the value with the least cost of all these events, which may repeat.
  double best(const std::vector<std::size_t>& events) const;

  /// Returns one standard deviation of best(), over samples of these whole events.
  double deviation(const std::vector<std::size_t>& events) const;

 private:
  std::function<double(double place)> value_at_;
  std::vector<double> values_;  // of the grid
  std::vector<double> costs_;   // row by row
};

}  // namespace robot::fit
