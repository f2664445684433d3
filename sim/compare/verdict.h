// Is B better than A? What a statistics says, how sure that is, and how many games a certainty takes.
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

/// B's gain over A per game, from the pairs. `unit`: how many of the metric's smallest units make one.
Interval gain_per_game(const PairStatistics& statistics, double unit = 1);

/// How much better those at home do than those away, per game, whoever plays there; 0 for a fair simulator.
Interval home_advantage(const PairStatistics& statistics, double unit = 1);

/// The variance of B's gain per game [unit^2], from pairs.
double pair_variance(const PairStatistics& statistics, double unit = 1);

/// How many times as many games it would take without pairs for the same certainty; 0 where that cannot be told.
double pairing_gain(const PairStatistics& statistics);

/// The hypothesis of a sequential test: is B's gain per game `h0`, or `h1`? (h0 < h1, in the metric's own unit)
struct Hypothesis {
  double h0 = 0, h1 = 0.1;
  double alpha = 0.05;  // how often h1 may be accepted where h0 is true
  double beta = 0.05;   // how often h0 may be accepted where h1 is true
  std::int64_t fewest_pairs = 50;
};

/// Where the log-likelihood ratio ends the test: {accept h0, accept h1} (Wald): -+2.944 for 5 % each.
struct Bounds {
  double h0 = 0, h1 = 0;
};
Bounds bounds_of(const Hypothesis& hypothesis);

/// The generalised log-likelihood ratio of h1 against h0: pairs of equal, unknown variance, N (h1 - h0) (2 mean - h0 - h1)
/// / (2 variance), as chess engines are tested (fishtest calls it LLR_alt2). Of pairs that are all alike it is +-infinity.
double llr(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit = 1);

enum class Verdict {
  better,
  not_better,
  undecided,
  identical,  // what B gained at one end, A gained at the other, in each pair: as a behaviour against itself
};
std::string_view name(Verdict verdict);

/// What the test says after these pairs.
Verdict decide(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit = 1);

/// What the interval says of a run of a fixed length: better where it lies above `h0` as a whole, not better where it does
/// not reach `h1`.
Verdict judge(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit = 1);

/// B's gain per game after a sequential test that has an answer: the mean of the pairs is the larger the sooner it stopped,
/// this one is as often too high as too low, and its interval covers the truth in 95 % (the test as Brownian motion
/// between its two bounds, outcomes in the order of when and where they stopped).
Interval unbiased_gain(const PairStatistics& statistics, const Hypothesis& hypothesis, double unit = 1);

/// How many pairs tell a gain of `delta` from none, for pairs of this variance.
struct Plan {
  double fixed_80 = 0, fixed_95 = 0;  // found in 80 % and in 95 % of runs of a fixed length
  double sequential = 0;              // the sequential test, on average where one of its answers is true
  double sequential_worst = 0;        // and where the truth lies in the middle
};
Plan plan(double variance, double delta);

}  // namespace sim::compare
