// The forecast from rollout statistics: the value of each strategy, its certainty, and the advice.
#pragma once

#include <string>

#include "sim/foresight/question.h"
#include "sim/foresight/rollout_statistics.h"

namespace sim::foresight {

/// The expected result of one strategy, in the unit of the measure.
///
/// Errors assume one more rollout that differs by half a unit (Jeffreys' half an event). Otherwise rollouts in which by
/// chance nothing happened would look certain.
struct Standing {
  int rollouts = 0;
  double mean = 0, error = 0;          // mean and its standard error
  double score = 0, concede = 0;       // [0..1] probability that the next goal is own, the opponents'
  double gain = 0;                     // over the incumbent, from common stripes
  double gain_low = 0, gain_high = 0;  // its 95 % interval
  double best = 0;                     // [0..1] the probability that it is the best of all
  bool raced_on = true;                // false: dropped before the end
};

struct Forecast {
  enum class Advice {
    none,    // too few rollouts
    keep,    // no gain exceeds chance and the cost of a change
    change,  // to `choice`
  };
  Advice advice = Advice::none;
  int strategies = 0;
  int choice = 0;      // index of the strategy to play; 0 (the incumbent) when none is better
  int challenger = 0;  // best of the others; 0: none
  Standing standings[kMaxStrategies];
};

/// Computes the forecast. It advises a change only when the gain of the best exceeds the switching cost with the
/// certainty of the question (one-sided).
Forecast forecast(const RolloutStatistics& statistics, const Question& question, RandomKey key);

/// Returns the advice in one sentence with its numbers: "keeps baseline: passing would gain 0.04 ± 0.09 goals, which
/// may be chance (212 futures)". `names` are the strategies', by index.
std::string reason(const Forecast& forecast, const Question& question, const std::string* names);

/// Returns the quantile `sure` (0.5 .. 1, one-sided) of Student's t for `freedom` >= 1 degrees. Within 1 % of the
/// tables from 3 degrees on. The same bits on every machine.
double student(double sure, double freedom);

}  // namespace sim::foresight
