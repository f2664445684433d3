// A comparison on a Slurm cluster: an array of jobs that play blocks, and one that merges them when all are done.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/contest/run_folder.h"

namespace sim::contest {

/// How a run is divided.
struct Division {
  std::int64_t blocks = 0;
  std::int64_t blocks_per_task = 1;

  std::int64_t tasks() const { return (blocks + blocks_per_task - 1) / blocks_per_task; }
};

/// A task plays for at least a minute, and there are no more than Slurm's usual 1000 of them.
Division divide(std::int64_t blocks, double seconds_per_block);

/// The scripts of the array and of the job that merges: `words` are those of this command line but for the engine.
std::string array_script(const std::vector<std::string>& words, const Division& division);
std::string merge_script(const std::vector<std::string>& words);

struct Submitted {
  std::string array, merge;  // Slurm's numbers of the jobs
};

/// Writes both scripts into the run's folder, which all machines must see, and hands them to sbatch.
robot::Result<Submitted> submit(const std::vector<std::string>& words, const Division& division,
                                const RunFolder& folder);

}  // namespace sim::contest
