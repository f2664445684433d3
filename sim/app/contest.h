// Plays a comparison to its end: blocks of pairs on all processors, judged one after the other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/app/comparison.h"
#include "sim/app/run_folder.h"
#include "sim/compare/verdict.h"

namespace sim::app {

struct ContestOptions {
  compare::Question question;
  std::optional<std::int64_t> pairs;  // a run of this length; nothing: until the sequential test has an answer
  double seconds = 0;                 // stop then in any case [s]; 0: no limit
  std::int64_t most_pairs = 200'000;  // of the sequential test
  int jobs = 1;                       // threads
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
  int gain = 0;  // of its two games
};

struct Outcome {
  compare::Tally tally;
  compare::Verdict verdict = compare::Verdict::undecided;
  std::vector<Mark> marks;              // one per block, thinned to at most some hundred
  std::vector<DecisivePair> decisive;   // the few with the largest gain of either behaviour
  std::vector<std::int64_t> histogram;  // of the pairs' gains, from -kWidest to kWidest; what is beyond is at the ends
  double seconds = 0;                   // it took

  static constexpr int kWidest = 20;
};

/// `progress` hears what is known after each block, in this thread. The result depends on nothing but the comparison and
/// the question, however fast which block was, unless the time is up.
robot::Result<Outcome> play_contest(const Comparison& comparison, const ContestOptions& options,
                                    const RunFolder* folder,
                                    const std::function<void(const Mark&, double games_per_minute)>& progress);

}  // namespace sim::app
