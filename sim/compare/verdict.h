// Is B better than A? The verdict from pair statistics, its certainty, and the number of games that it needs.
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/compare/pair_statistics.h"

namespace sim::compare {

/// A mean with its 95 % interval (Student's t). The interval is infinite for fewer than two values.
struct Interval {
  double mean = 0;
  double low = 0, high = 0;
};

/// Returns B's gain over A per game. `unit`: number of the metric's smallest units in one.
Interval gain_per_game(const PairStatistics& statistics, double unit = 1);

/// Returns the advantage of the home end per game, whichever behaviour plays there; 0 for a fair simulator.
Interval home_advantage(const PairStatistics& statistics, double unit = 1);

/// Returns the variance of B's gain per game [unit^2], from pairs.
double pair_variance(const PairStatistics& statistics, double unit = 1);

/// Returns the factor of games that the same certainty would need without pairs, or 0 when that is unknown.
double pairing_gain(const PairStatistics& statistics);

/// The two hypotheses of a sequential test: B's gain per game is `h0` or `h1` (h0 < h1, in the metric's own unit).
struct Hypothesis {
  double h0 = 0, h1 = 0.1;
  double part = 0;      // above 0: h1 is h0 and this part of the gain's standard deviation, see asked()
  double alpha = 0.05;  // allowed rate of accepting h1 when h0 is true
  double beta = 0.05;   // allowed rate of accepting h0 when h1 is true
  std::int64_t fewest_pairs = 50;
};

/// The usual `part`: about 0.1 goals of a whole game, and 3 of 100 chances. A test needs about 600 pairs for any metric.
inline constexpr double kUsualPart = 0.1;

/// A verdict needs this number of pairs with a gain. With fewer the variance is hardly known.
inline constexpr std::int64_t kFewestUneven = 10;

/// Returns the question with its `h1` in the metric's unit. With `part` it uses the standard deviation of the gain per
/// game (the mean of a pair's two) over all pairs so far. The result is a function of the pairs alone.
Hypothesis asked(const Hypothesis& hypothesis, const PairStatistics& statistics, double unit = 1);

/// The bounds of the log-likelihood ratio that end the test (Wald): -2.944 and +2.944 for 5 % each.
struct Bounds {
  double h0 = 0, h1 = 0;
};
Bounds bounds_of(const Hypothesis& hypothesis);

/// Returns the generalised log-likelihood ratio of h1 against h0. Pairs have equal, unknown variance: N (h1 - h0) (2
/// mean - h0 - h1) / (2 variance), as in tests of chess engines (LLR_alt2 of fishtest). It is
/// +-infinity when all pairs are equal. The functions below use asked() as well.
double llr(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit = 1);

enum class Verdict {
  better,
  not_better,
  undecided,
  identical,  // in each pair B played exactly what A played: as a behaviour against itself
  too_rare,   // the games differ, but almost no pair has a gain
};
std::string_view name(Verdict verdict);

/// Returns the verdict of the sequential test after these pairs. It is too_rare when 1000 pairs have fewer than
/// kFewestUneven gains.
Verdict decide(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit = 1);

/// Returns the verdict of a run of fixed length from its interval: better when the whole interval is above `h0`, not
/// better when it is below `h1`. With fewer than kFewestUneven gains it is too_rare if these are less than 5 % of the
/// pairs, and otherwise undecided.
Verdict judge(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit = 1);

/// Returns B's gain per game after a sequential test with an answer. The plain mean is too large after an early stop.
/// This one is too high as often as too low, and its interval covers the truth in 95 % of tests. It models the test as
/// Brownian motion between its bounds, with outcomes ordered by the time and place of the stop.
Interval unbiased_gain(const PairStatistics& statistics, const Hypothesis& question, double unit = 1);

/// The number of pairs that distinguishes a gain of `delta` from none, for pairs of this variance.
struct Plan {
  double fixed_80 = 0, fixed_95 = 0;  // found in 80 % and in 95 % of runs of a fixed length
  double sequential = 0;              // mean of the sequential test when h0 or h1 is true
  double sequential_worst = 0;        // mean when the truth is in the middle
};
Plan plan(double variance, double delta);

}  // namespace sim::compare
