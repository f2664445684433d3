// The kinds of runs of compare, beside the plain verdict.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/contest/contest.h"

namespace sim::app {

/// The options of compare.
struct CompareTask {
  contest::ComparisonChoice choice;
  contest::ContestOptions contest;
  std::int64_t pairs = 0;  // --pairs; 0: not given
  double delta = 0;        // --delta; 0: not given
  std::string out, pilot, blocks;
  bool json = false;
};

inline constexpr int kNo = 1, kUndecided = 3;
/// Returns the exit status of a verdict.
int status_of(compare::Verdict verdict);

/// Returns a function that prints the state of the test on a terminal, or an empty one without a terminal.
std::function<void(const contest::Mark&, double games_per_minute)> progress_line(
    const contest::ContestOptions& options);
/// Clears that line.
void clear_line();

// Each function prints its result and returns the exit status.

/// Estimates the number of games that an answer needs.
int run_plan(const CompareTask& task, const contest::Comparison& comparison);
/// Repeats the verdict under other models, with one change at a time.
int run_robust(CompareTask task);
/// Compares a behaviour with itself, as a test that only the behaviour decides. Each pair must be the same game twice.
/// Games with different seeds must favour neither end of the field. In half of them the sides exchange the situation, so
/// that its own advantage is nobody's.
int run_itself(CompareTask task);
/// Plays the requested blocks of a run.
int run_blocks(const CompareTask& task, const contest::Comparison& comparison, const contest::RunFolder& folder);
/// Plays two blocks again and compares them.
int run_verify(const CompareTask& task, const contest::Comparison& comparison, const contest::RunFolder& folder);
/// Submits the run to a Slurm cluster. `words` is the command line of a job without its part of the blocks.
int run_slurm(const CompareTask& task, const contest::Comparison& comparison, const contest::RunFolder& folder,
              const std::vector<std::string>& words);

}  // namespace sim::app
