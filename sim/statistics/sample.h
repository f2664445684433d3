// Mean, quantile and share of a list of values. A figure without values is NaN: it was not measured.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace sim::statistics {

/// Returns the mean, or NaN of an empty list.
double mean_of(const std::vector<double>& values);

/// Returns the value below which `share` [0..1] of the values lie, or NaN of an empty list. Between two values it
/// interpolates linearly.
double quantile(std::vector<double> values, double share);

inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

/// Returns hits / cases, or NaN without cases.
double ratio(double hits, double cases);

/// A count of cases and of hits among them.
struct Share {
  std::size_t hits = 0, cases = 0;

  void add(bool hit) { ++cases, hits += hit ? 1 : 0; }
  double value() const { return ratio(static_cast<double>(hits), static_cast<double>(cases)); }
};

}  // namespace sim::statistics
