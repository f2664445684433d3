// A comparison on a Slurm cluster: an array of jobs plays the blocks, and one more job merges them at the end.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/contest/run_folder.h"

namespace sim::contest {

/// The division of a run's blocks into tasks.
struct Division {
  std::int64_t blocks = 0;
  std::int64_t blocks_per_task = 1;

  std::int64_t tasks() const { return (blocks + blocks_per_task - 1) / blocks_per_task; }
};

/// Divides a run so that a task plays for at least a minute, with at most 1000 tasks: Slurm's usual limit.
Division divide(std::int64_t blocks, double seconds_per_block);

/// Return the scripts of the array and of the job that merges. `words` is this command line without the engine.
std::string array_script(const std::vector<std::string>& words, const Division& division);
std::string merge_script(const std::vector<std::string>& words);

struct Submitted {
  std::string array, merge;  // job numbers from Slurm
};

/// Writes both scripts into the run's folder and submits them with sbatch. All machines must see the folder.
robot::Result<Submitted> submit(const std::vector<std::string>& words, const Division& division,
                                const RunFolder& folder);

}  // namespace sim::contest
