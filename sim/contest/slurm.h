// A comparison on a Slurm cluster: an array of jobs that play blocks, and one job that merges them at the end.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/contest/run_folder.h"

namespace sim::contest {

/// The division of a run into tasks.
struct Division {
  std::int64_t blocks = 0;
  std::int64_t blocks_per_task = 1;

  std::int64_t tasks() const { return (blocks + blocks_per_task - 1) / blocks_per_task; }
};

/// Divides a run. A task plays for at least a minute, and there are at most 1000 tasks, Slurm's usual limit.
Division divide(std::int64_t blocks, double seconds_per_block);

/// Return the scripts of the array and of the merging job. `words` is this command line without the engine.
std::string array_script(const std::vector<std::string>& words, const Division& division);
std::string merge_script(const std::vector<std::string>& words);

struct Submitted {
  std::string array, merge;  // Slurm's job numbers
};

/// Writes both scripts into the run's folder, which all machines must see, and submits them with sbatch.
robot::Result<Submitted> submit(const std::vector<std::string>& words, const Division& division,
                                const RunFolder& folder);

}  // namespace sim::contest
