// What a statistics says: what each strategy is worth, how sure that is, and whether to change.
#pragma once

#include <string>

#include "sim/foresight/question.h"
#include "sim/foresight/rollout_statistics.h"

namespace sim::foresight {

/// What is expected of one strategy. Values are in the unit of the measure.
///
/// Errors are those of as many rollouts, of which one more had come out half a unit aside: where by chance nothing happened
/// in any, that is not sure yet (Jeffreys' half an event).
struct Standing {
  int rollouts = 0;
  double mean = 0, error = 0;          // and its standard error
  double score = 0, concede = 0;       // [0..1] how often the next goal is one's own, the others'
  double gain = 0;                     // over the incumbent, in the stripes that both played
  double gain_low = 0, gain_high = 0;  // its 95 % interval
  double best = 0;                     // [0..1] the probability that it is the best of all
  bool raced_on = true;                // false: left behind before the end
};

struct Forecast {
  enum class Advice {
    none,    // too few rollouts to tell: no advice
    keep,    // nothing gains more than chance and the change's cost explain
    change,  // to `choice`
  };
  Advice advice = Advice::none;
  int strategies = 0;
  int choice = 0;      // index of the strategy to play; the incumbent's, 0, where nothing is better
  int challenger = 0;  // the best of the others; 0: there is none
  Standing standings[kMaxStrategies];
};

/// It changes when the gain of the best is above the switching cost for as sure as the question asks (one-sided), never
/// else.
Forecast forecast(const RolloutStatistics& statistics, const Question& question, RandomKey key);

/// The advice in one sentence, with the numbers behind it: "keeps baseline: passing would gain 0.04 ± 0.09 goals, which
/// may be chance (212 futures)". `names` are the strategies', by index.
std::string reason(const Forecast& forecast, const Question& question, const std::string* names);

/// How far Student's t reaches with the probability `sure` (0.5 .. 1, one-sided), for `freedom` >= 1 degrees; within 1 % of
/// the tables from 3 degrees on. The same bits everywhere.
double student(double sure, double freedom);

}  // namespace sim::foresight
