// Runs on a Slurm cluster. Of a comparison, an array of jobs plays the blocks, and one more job merges them at the end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/contest/run_folder.h"

namespace sim::contest {

/// The most tasks of an array: Slurm's usual limit.
inline constexpr int kMostTasks = 1000;

/// The division of a run's blocks into tasks.
struct Division {
  std::int64_t blocks = 0;
  std::int64_t blocks_per_task = 1;

  std::int64_t tasks() const { return (blocks + blocks_per_task - 1) / blocks_per_task; }
};

/// Divides a run so that a task plays for at least a minute, with at most kMostTasks tasks.
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

/// Returns the script of an array of `tasks` jobs that play a run together (--share).
std::string sharing_script(const std::vector<std::string>& words, int tasks);

/// Writes a script into `folder`, which all machines must see, and submits it with sbatch and more of its options. The log
/// lies beside it. Returns the number of the job.
robot::Result<std::string> submit_script(const std::filesystem::path& folder, const std::string& name,
                                         const std::string& script, const std::string& options = "");

}  // namespace sim::contest
