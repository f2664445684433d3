#include "sim/contest/slurm.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "robot/core/files.h"

namespace sim::contest {
namespace {

using robot::Error;
using robot::Result;

constexpr double kTaskSeconds = 60;  // [s] shortest task: Slurm needs about half a second to start one

std::string quoted(const std::string& word) {
  std::string all = "'";
  for (const char c : word) all += c == '\'' ? "'\\''" : std::string(1, c);
  return all + "'";
}

std::string command_line(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + quoted(word);
  return all;
}

constexpr const char* kHead = "#!/bin/sh\n#SBATCH --ntasks=1\n";

std::string array_head(std::int64_t tasks) {
  return kHead + std::string("#SBATCH --array=0-") + std::to_string(tasks - 1) + "\n#SBATCH --requeue\n";
}

/// Returns the lines that run a command, and again after a kill: it goes on with what it has written. Slurm itself handles
/// a lost node. The shell's $status is the command's.
std::string again_after_kills(const std::string& command) {
  return "for try in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do\n  " + command +
         "\n  status=$?\n  [ \"$status\" -gt 128 ] || break\n  sleep 1\ndone\n";
}

// an answer such as "not better" or "undecided" is no failure of the job
constexpr const char* kEndOfAnswer = "[ \"$status\" -lt 2 ] || [ \"$status\" = 3 ]\n";

/// Runs sbatch. Returns the number of the job.
Result<std::string> sbatch(const std::string& arguments) {
  const std::string command = "sbatch --parsable " + arguments;
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen((command + " 2>&1").c_str(), "r"), pclose);
  if (!output) return Error{"cannot run sbatch"};
  std::string said;
  for (int c = 0; (c = std::fgetc(output.get())) != EOF;)
    if (said.size() < 1000) said += static_cast<char>(c);
  while (!said.empty() && said.back() == '\n') said.pop_back();
  // "number" or "number;cluster"
  const std::string number = said.substr(0, said.find(';'));
  if (number.empty() || number.find_first_not_of("0123456789") != number.npos)
    return Error{"sbatch: expected the number of a job, got '" + said + "'"};
  return number;
}

}  // namespace

Division divide(std::int64_t blocks, double seconds_per_block) {
  const auto for_a_minute = static_cast<std::int64_t>(std::ceil(kTaskSeconds / std::max(seconds_per_block, 1e-3)));
  const std::int64_t for_few = (blocks + kMostTasks - 1) / kMostTasks;
  return {.blocks = blocks, .blocks_per_task = std::clamp(for_a_minute, for_few, std::max(blocks, for_few))};
}

std::string array_script(const std::vector<std::string>& words, const Division& division) {
  const std::string per_task = std::to_string(division.blocks_per_task), blocks = std::to_string(division.blocks);
  return array_head(division.tasks()) + "from=$((SLURM_ARRAY_TASK_ID * " + per_task + "))\nto=$((from + " + per_task +
         "))\n[ \"$to\" -le " + blocks + " ] || to=" + blocks + "\n" +
         again_after_kills(command_line(words) + " --blocks \"$from..$to\"") + "exit \"$status\"\n";
}

std::string merge_script(const std::vector<std::string>& words) {
  return kHead + command_line(words) + " --merge\nstatus=$?\n" + kEndOfAnswer;
}

std::string sharing_script(const std::vector<std::string>& words, int tasks) {
  const std::string share = " --share \"$SLURM_ARRAY_TASK_ID/" + std::to_string(tasks) + "\"";
  return array_head(tasks) + again_after_kills(command_line(words) + share) + kEndOfAnswer;
}

Result<std::string> submit_script(const std::filesystem::path& folder, const std::string& name,
                                  const std::string& script, const std::string& options) {
  const std::filesystem::path where = robot::absolute_path(folder), path = where / (name + ".sh"),
                              log = where / (name + "-%j.log");
  if (auto written = robot::replace_file(path, script, 0755); !written) return written.failure();
  return sbatch(options + (options.empty() ? "" : " ") + "--job-name=foresight-" + name +
                " --output=" + quoted(log.string()) + " " + quoted(path.string()));
}

Result<Submitted> submit(const std::vector<std::string>& words, const Division& division, const RunFolder& folder) {
  const auto array = submit_script(folder.path(), "blocks", array_script(words, division));
  if (!array) return array.failure();
  const auto merging = submit_script(folder.path(), "merge", merge_script(words), "--dependency=afterok:" + *array);
  if (!merging) return merging.failure();
  return Submitted{*array, *merging};
}

}  // namespace sim::contest
