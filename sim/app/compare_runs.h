// What compare does with a question: what else there is than the plain verdict.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/contest/contest.h"

namespace sim::app {

/// What compare was asked.
struct CompareTask {
  contest::ComparisonChoice choice;
  contest::ContestOptions contest;
  std::int64_t pairs = 0;  // --pairs; 0: not given
  double delta = 0;        // --delta; 0: not given
  std::string out, pilot, blocks;
  bool json = false;
};

inline constexpr int kNo = 1, kUndecided = 3;
/// The exit status that a verdict ends with.
int status_of(compare::Verdict verdict);

/// What is known so far, on a terminal; nothing elsewhere.
std::function<void(const contest::Mark&, double games_per_minute)> progress_line(
    const contest::ContestOptions& options);
/// Takes it away.
void clear_line();

// Each tells what it found and returns the exit status.

/// How many games an answer takes.
int run_plan(const CompareTask& task, const contest::Comparison& comparison);
/// The verdict under the models as they are, then with one thing after the other changed.
int run_robust(CompareTask task);
/// A behaviour against itself: the free test that nothing but the behaviour decides. Pairs must come out even, and games
/// of luck of their own must favour neither end of the field.
int run_itself(CompareTask task);
/// Plays the blocks of a run that were asked for.
int run_blocks(const CompareTask& task, const contest::Comparison& comparison, const contest::RunFolder& folder);
/// Plays two blocks again and compares them.
int run_verify(const CompareTask& task, const contest::Comparison& comparison, const contest::RunFolder& folder);
/// Hands the run to a Slurm cluster; `words`: the command line of a job but for what part it plays.
int run_slurm(const CompareTask& task, const contest::Comparison& comparison, const contest::RunFolder& folder,
              const std::vector<std::string>& words);

}  // namespace sim::app
