#include "sim/statistics/sample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sim::statistics {

double ratio(double hits, double cases) { return cases > 0 ? hits / cases : std::numeric_limits<double>::quiet_NaN(); }

double mean_of(const std::vector<double>& values) {
  return ratio(std::accumulate(values.begin(), values.end(), 0.), static_cast<double>(values.size()));
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(place);
  std::ranges::nth_element(values, values.begin() + below);
  const double low = values[static_cast<std::size_t>(below)];
  const double rest = place - static_cast<double>(below);
  if (rest == 0) return low;
  const double high = *std::ranges::min_element(values.begin() + below + 1, values.end());
  return std::lerp(low, high, rest);
}

}  // namespace sim::statistics
