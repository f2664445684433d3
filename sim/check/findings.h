// The games of a situation, and what they show about its metrics.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/check/scenario.h"

namespace sim::check {

/// An interval of 95 % confidence.
struct Interval {
  double low = 0, high = 0;
};

/// Returns the interval of a share: Wilson's, which is right also near 0 and 1. `all` > 0.
Interval interval_of_share(int yes, int all);
/// Returns the interval of the mean of these values: 1.96 standard errors to each side.
Interval interval_of_mean(const std::vector<double>& values);

/// `passed`: the mean is within the limits. `unsure`: it is not, but the interval reaches them; more seeds decide.
/// `failed`: the whole interval is beyond a limit, or no game has a value.
enum class Verdict { none, passed, unsure, failed };  // none: the metric has no limits

struct Finding {
  const NamedMetric* metric = nullptr;
  int games = 0;  // with a value
  double mean = 0;
  Interval interval;
  Verdict verdict = Verdict::none;
};

/// Judges the values of a metric in the games that have one.
Finding judge(const NamedMetric& metric, const std::vector<double>& values);

/// Plays the scenario once per seed. The result depends only on the scenario. Calls `progress` with the number of
/// finished games.
robot::Result<std::vector<Finding>> play(const Scenario& scenario, const std::function<void(int)>& progress = {});

}  // namespace sim::check
