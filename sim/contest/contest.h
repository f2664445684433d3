// Plays a comparison to its end: blocks of pairs on all processors, judged in order.
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
  std::optional<std::int64_t> pairs;  // length of the run; absent: until the sequential test answers
  double seconds = 0;                 // time limit [s]; 0: none
  std::int64_t most_pairs = 200'000;  // limit of the sequential test
  int jobs = 1;                       // processes

  std::int64_t most_blocks() const {
    return (pairs.value_or(most_pairs) + RunFolder::kPairsPerBlock - 1) / RunFolder::kPairsPerBlock;
  }
};

/// The state of the test after a block.
struct Mark {
  std::int64_t pairs = 0;
  compare::Interval gain;
  double llr = 0;
};

/// A pair that one behaviour clearly won.
struct DecisivePair {
  std::int64_t number = 0;
  int gain = 0;  // sum of its two games [smallest units of the metric]
};

struct Outcome {
  compare::PairStatistics tally;
  compare::Verdict verdict = compare::Verdict::undecided;
  bool sequential = false;             // the sequential test has answered
  std::vector<Mark> marks;             // one per block, thinned to a few hundred at most
  std::vector<DecisivePair> decisive;  // the largest gains of either behaviour
  std::vector<std::int64_t>
      histogram;         // of the pairs' gains, from -kWidest to kWidest columns; larger gains are at the ends
  DecisionCost cost[2];  // of A, of B, in the games played now
  double seconds = 0;    // duration [s]

  static constexpr int kWidest = 20;
};

/// Returns the width of a histogram column [units of the metric].
constexpr double column_of(Metric metric) { return metric == Metric::ball_advance ? 0.5 : 1; }

/// Plays until the run or the sequential test ends. `progress` is called after each block. The result depends only on the
/// comparison and the question, not on the speed of the blocks, unless the time limit ends the run. Blocks in `folder` are
/// not played again.
robot::Result<Outcome> play_contest(const Comparison& comparison, const ContestOptions& options,
                                    const RunFolder* folder,
                                    const std::function<void(const Mark&, double games_per_minute)>& progress);

/// Plays the missing blocks among from .. to - 1, without a verdict. Other processes may play other blocks of the run.
robot::Result<void> play_blocks(const Comparison& comparison, std::int64_t from, std::int64_t to, int jobs,
                                const RunFolder& folder);

/// Returns the verdict of all blocks in `folder`. Returns an Error for a gap or a block of another run.
robot::Result<Outcome> merge(const Comparison& comparison, const ContestOptions& options, const RunFolder& folder);

}  // namespace sim::contest
