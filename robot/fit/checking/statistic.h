// A number of a recording beside the same number of many simulated recordings. Pure.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace robot::fit {

/// Simulated recordings for each statistic: enough for quantiles far from the middle.
inline constexpr std::size_t kCheckSamples = 4000;

struct Statistic {
  std::string name;  // "walk: way ahead in a second"
  std::string unit;  // "m"
  double recorded = 0;
  std::vector<double> simulated;  // kCheckSamples, in any order
  std::size_t events = 0;         // of the recording
  std::string kind;               // of the events: "stretches"
};

/// The verdict on one statistic.
struct Verdict {
  double middle = 0, low = 0, high = 0;  // median and interval of the simulated values
  bool inside = true;

  /// Returns the distance of the recorded value from the middle, in half intervals: below -1 and above 1 it is outside. Where the
  /// interval has no width it is 0 or ±infinity.
  double distance(double recorded) const;
};

/// Judges all statistics at once: with right models all are inside in 95 % of recordings, or more where they depend on each other.
/// So each interval has the level 1 - 0.05 / K for K statistics, and its ends are quantiles of the simulated values.
std::vector<Verdict> judge(const std::vector<Statistic>& statistics);

}  // namespace robot::fit
