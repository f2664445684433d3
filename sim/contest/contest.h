// Plays a comparison to its end: blocks of pairs on all processors, judged one after the other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/compare/verdict.h"
#include "sim/contest/comparison.h"
#include "sim/contest/run_folder.h"

namespace sim::contest {

struct ContestOptions {
  compare::Hypothesis question;
  std::optional<std::int64_t> pairs;  // a run of this length; nothing: until the sequential test has an answer
  double seconds = 0;                 // stop then in any case [s]; 0: no limit
  std::int64_t most_pairs = 200'000;  // of the sequential test
  int jobs = 1;                       // processes

  std::int64_t most_blocks() const {
    return (pairs.value_or(most_pairs) + RunFolder::kPairsPerBlock - 1) / RunFolder::kPairsPerBlock;
  }
};

/// What was known after a block.
struct Mark {
  std::int64_t pairs = 0;
  compare::Interval gain;
  double llr = 0;
};

/// A pair that one behaviour won clearly.
struct DecisivePair {
  std::int64_t number = 0;
  int gain = 0;  // of its two games [smallest units of the metric]
};

struct Outcome {
  compare::PairStatistics tally;
  compare::Verdict verdict = compare::Verdict::undecided;
  bool sequential = false;             // the test itself has answered
  std::vector<Mark> marks;             // one per block, thinned to at most some hundred
  std::vector<DecisivePair> decisive;  // the few with the largest gain of either behaviour
  std::vector<std::int64_t>
      histogram;         // of the pairs' gains, from -kWidest to kWidest columns; what is beyond is at the ends
  DecisionCost cost[2];  // of A, of B, as far as games were played now
  double seconds = 0;    // it took

  static constexpr int kWidest = 20;
};

/// How much of the metric a column of the histogram is wide.
constexpr double column_of(Metric metric) { return metric == Metric::ball_advance ? 0.5 : 1; }

/// `progress` hears what is known after each block. The result depends on nothing but the comparison and the question,
/// however fast which block was, unless the time is up. Blocks that `folder` has are not played again.
robot::Result<Outcome> play_contest(const Comparison& comparison, const ContestOptions& options,
                                    const RunFolder* folder,
                                    const std::function<void(const Mark&, double games_per_minute)>& progress);

/// Plays the blocks from .. to - 1 that `folder` does not have, and judges nothing: a part of a run that others share.
robot::Result<void> play_blocks(const Comparison& comparison, std::int64_t from, std::int64_t to, int jobs,
                                const RunFolder& folder);

/// The verdict of the blocks in `folder`, which must be all that the run has: gaps and strangers are refused.
robot::Result<Outcome> merge(const Comparison& comparison, const ContestOptions& options, const RunFolder& folder);

}  // namespace sim::contest
