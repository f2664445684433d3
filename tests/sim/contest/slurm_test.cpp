#include "sim/contest/slurm.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>

#include "tests/support/temporary_folder.h"

namespace sim::contest {
namespace {

TEST(Slurm, TasksCoverEachBlockOnceAndAreAtMostAThousand) {
  for (const std::int64_t blocks : {1, 2, 40, 999, 1000, 1001, 8000})
    for (const double seconds : {0., 0.001, 0.7, 59., 61., 1e4}) {
      const Division division = divide(blocks, seconds);
      EXPECT_LE(division.tasks(), 1000);
      EXPECT_GE(division.blocks_per_task, 1);
      // the last task ends at or beyond the last block, and begins before its end: none is empty
      EXPECT_GE(division.tasks() * division.blocks_per_task, blocks);
      EXPECT_LT((division.tasks() - 1) * division.blocks_per_task, blocks);
    }
}

TEST(Slurm, ATaskPlaysForAMinuteUnlessTheRunIsShorter) {
  EXPECT_EQ(divide(100, 10).blocks_per_task, 6);
  EXPECT_EQ(divide(100, 600).blocks_per_task, 1);
  EXPECT_EQ(divide(3, 1).blocks_per_task, 3);
}

/// Runs a script as a task of an array. Returns its output.
std::string output_of(const std::filesystem::path& script, int task) {
  const std::string command = "SLURM_ARRAY_TASK_ID=" + std::to_string(task) + " sh '" + script.string() + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  std::string said;
  for (int c = 0; output && (c = std::fgetc(output.get())) != EOF;) said += static_cast<char>(c);
  return said;
}

TEST(Slurm, TheScriptOfTheArrayGivesEachTaskItsBlocks) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path script = folder.path() / "blocks.sh";
  std::ofstream(script) << array_script({"echo", "it's one word"}, {.blocks = 7, .blocks_per_task = 3});
  EXPECT_EQ(output_of(script, 0), "it's one word --blocks 0..3\n");
  EXPECT_EQ(output_of(script, 1), "it's one word --blocks 3..6\n");
  EXPECT_EQ(output_of(script, 2), "it's one word --blocks 6..7\n");
}

TEST(Slurm, AMergeFailsOnBadInputOnly) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path script = folder.path() / "merge.sh";
  for (const int status : {0, 1, 2, 3, 127}) {
    std::ofstream(script) << merge_script({"sh", "-c", "exit " + std::to_string(status)});
    const int ended = std::system(("sh '" + script.string() + "'").c_str());
    EXPECT_EQ(WEXITSTATUS(ended) == 0, status != 2 && status != 127) << status;
  }
}

TEST(Slurm, AShareIsTheNumberOfATask) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path script = folder.path() / "learn.sh";
  std::ofstream(script) << sharing_script({"echo", "learn"}, 5);
  EXPECT_EQ(output_of(script, 0), "learn --share 0/5\n");
  EXPECT_EQ(output_of(script, 4), "learn --share 4/5\n");
}

TEST(Slurm, AKilledTaskIsRunAgainAndAnAnswerIsNoFailure) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path script = folder.path() / "learn.sh", mark = folder.path() / "mark";
  const std::string once =
      "[ -e '" + mark.string() + "' ] || { touch '" + mark.string() + "'; kill -KILL $$; }; exit 1";
  std::ofstream(script) << sharing_script({"sh", "-c", once}, 1);
  EXPECT_EQ(std::system(("SLURM_ARRAY_TASK_ID=0 sh '" + script.string() + "'").c_str()), 0);
  EXPECT_TRUE(std::filesystem::exists(mark));
}

}  // namespace
}  // namespace sim::contest
