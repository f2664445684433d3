// Plays a comparison to its end: blocks of pairs on all processors, judged in their order.
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
  std::optional<std::int64_t> pairs;  // fixed length of the run; absent: until the sequential test has an answer
  double seconds = 0;                 // [s] time limit; 0: none
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

/// A pair that one behaviour won clearly.
struct DecisivePair {
  std::int64_t number = 0;
  int gain = 0;  // of its two games [smallest units of the metric]
};

struct Outcome {
  compare::PairStatistics tally;
  std::int64_t different = 0;  // pairs that are no repetition of an earlier one
  compare::Verdict verdict = compare::Verdict::undecided;
  bool sequential = false;             // the test itself has answered
  std::vector<Mark> marks;             // one per block, thinned to at most 400
  std::vector<DecisivePair> decisive;  // at most 5 per behaviour, with the largest gains
  std::vector<std::int64_t>
      histogram;         // of the pairs' gains, from -kWidest to kWidest columns; the ends hold larger gains
  DecisionCost cost[2];  // of A, of B; without blocks that were read from the disk
  double seconds = 0;    // duration [s]

  static constexpr int kWidest = 20;
};

/// Returns the width of a column of the histogram, in the metric's unit.
constexpr double column_of(Metric metric) { return metric == Metric::ball_advance ? 0.5 : 1; }

/// Number of pairs whose hashes are remembered to find repetitions, so that memory does not grow.
inline constexpr std::size_t kRemembered = 100'000;

/// Plays blocks until there is a verdict. Returns an Error if pairs repeat earlier ones, because the seed changes nothing:
/// they are no independent games, and no interval holds for them. Pairs in which B played what A played may repeat. Calls `progress` after each block. The result depends only on the comparison
/// and the options, not on the order in which blocks finish, unless the time limit ends the run. Blocks that are in
/// `folder` are not played again; `folder` may be null.
robot::Result<Outcome> play_contest(const Comparison& comparison, const ContestOptions& options,
                                    const RunFolder* folder,
                                    const std::function<void(const Mark&, double games_per_minute)>& progress);

/// Plays those of the blocks from .. to - 1 that are not in `folder`, without a verdict: one part of a shared run.
robot::Result<void> play_blocks(const Comparison& comparison, std::int64_t from, std::int64_t to, int jobs,
                                const RunFolder& folder);

/// Returns the outcome of the blocks in `folder`. An Error names missing and damaged blocks and blocks of another run.
robot::Result<Outcome> merge(const Comparison& comparison, const ContestOptions& options, const RunFolder& folder);

}  // namespace sim::contest
