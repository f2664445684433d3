#include "robot/fit/math/simplex.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace robot::fit {
namespace {

constexpr int kMostRounds = 600;
constexpr double kLeastSpread = 1e-7;  // of the values at the corners

struct Corner {
  Vector parameters;
  double value;
};

/// Returns from + share (to - from).
Vector between(const Vector& from, const Vector& to, double share) {
  Vector point = from;
  for (std::size_t i = 0; i < point.size(); ++i) point[i] += share * (to[i] - from[i]);
  return point;
}

/// Returns the middle of all corners but the last.
Vector middle_of(const std::vector<Corner>& corners) {
  Vector middle(corners.front().parameters.size());
  const auto count = static_cast<double>(corners.size() - 1);
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    for (std::size_t i = 0; i < middle.size(); ++i) middle[i] += corners[k].parameters[i] / count;
  return middle;
}

}  // namespace

Vector least_of(const std::function<double(const Vector& parameters)>& value, const Vector& start,
                const Vector& steps) {
  const auto corner_at = [&](Vector parameters) {
    const double there = value(parameters);
    return Corner{.parameters = std::move(parameters), .value = std::isnan(there) ? INFINITY : there};
  };
  std::vector<Corner> corners{corner_at(start)};
  for (std::size_t i = 0; i < start.size(); ++i) {
    Vector moved = start;
    moved[i] += steps[i];
    corners.push_back(corner_at(std::move(moved)));
  }
  for (int round = 0; round < kMostRounds; ++round) {
    std::ranges::stable_sort(corners, {}, &Corner::value);
    Corner& worst = corners.back();
    if (worst.value - corners.front().value < kLeastSpread) break;
    const Vector middle = middle_of(corners);
    Corner reflected = corner_at(between(middle, worst.parameters, -1));
    if (reflected.value < corners.front().value) {
      Corner further = corner_at(between(middle, worst.parameters, -2));
      worst = further.value < reflected.value ? std::move(further) : std::move(reflected);
    } else if (reflected.value < corners[corners.size() - 2].value) {
      worst = std::move(reflected);
    } else {
      if (reflected.value < worst.value) worst = std::move(reflected);
      Corner nearer = corner_at(between(middle, worst.parameters, 0.5));
      if (nearer.value < worst.value) {
        worst = std::move(nearer);
        continue;
      }
      for (std::size_t k = 1; k < corners.size(); ++k)
        corners[k] = corner_at(between(corners.front().parameters, corners[k].parameters, 0.5));
    }
  }
  return std::ranges::min_element(corners, {}, &Corner::value)->parameters;
}

}  // namespace robot::fit
