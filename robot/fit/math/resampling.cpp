#include "robot/fit/math/resampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace robot::fit {

double deviation_of_median(double distance, std::size_t count) {
  return 1.25 * kOfMedian * distance / std::sqrt(static_cast<double>(count));
}

Group all_of(std::size_t count) {
  Group all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::vector<Group> single_groups(std::size_t count) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < count; ++i) groups.push_back({i});
  return groups;
}

std::vector<Vector> resampled(const std::vector<Group>& groups, std::size_t count, const Estimate& estimate) {
  std::mt19937_64 random(1);  // its numbers are the same everywhere
  std::vector<Vector> estimates;
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < count; ++i) {
    drawn.clear();
    for (std::size_t k = 0; k < groups.size(); ++k) {
      const Group& group = groups[random() % groups.size()];
      drawn.insert(drawn.end(), group.begin(), group.end());
    }
    estimates.push_back(estimate(drawn));
  }
  return estimates;
}

Vector deviations_of(const std::vector<Vector>& estimates) {
  const auto count = static_cast<double>(estimates.size());
  Vector deviations(estimates.front().size());
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    double sum = 0, squares = 0;
    for (const Vector& estimate : estimates) sum += estimate[i];
    for (const Vector& estimate : estimates) squares += std::pow(estimate[i] - sum / count, 2);
    deviations[i] = std::sqrt(squares / (count - 1));
  }
  return deviations;
}

double two_sided(std::size_t freedom) {
  if (freedom == 1) return 12.706;
  if (freedom == 2) return 4.303;
  constexpr double z = 1.959964;
  const auto n = static_cast<double>(freedom);
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * n * n * n);
}

}  // namespace robot::fit
