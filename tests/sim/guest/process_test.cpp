#include "sim/guest/process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"

namespace sim::guest {
namespace {

/// Longest wait for an answer [s]; only a failure takes this long.
constexpr double kPatience = 60;

robot::Result<std::string> answer_of(const std::string& command, double patience = kPatience) {
  auto process = Process::start(command);
  if (!process) return robot::Error{process.error()};
  return process->ask("hello\n", patience);
}

TEST(Process, AnswersALineWithALine) {
  auto process = Process::start("cat");
  ASSERT_TRUE(process);
  for (const char* line : {"one\n", "two\n", "three\n"}) {
    const auto answer = process->ask(line, kPatience);
    ASSERT_TRUE(answer) << answer.error();
    EXPECT_EQ(*answer + "\n", line);
  }
}

TEST(Process, SaysHowItEnded) {
  EXPECT_EQ(answer_of("sh -c 'read x; exit 4'").error(), "the process ended with status 4 instead of answering");
  EXPECT_EQ(answer_of("sh -c 'read x; kill -9 $$'").error(), "the process was killed by signal 9");
  EXPECT_EQ(answer_of("no-such-command-anywhere 2>/dev/null").error(),
            "the command was not found, or ended with status 127");
}

TEST(Process, TimesOut) { EXPECT_EQ(answer_of("sleep 60", 0.2).error(), "the process did not answer within 0.2 s"); }

TEST(Process, AnswersOneLineOfALimitedLength) {
  EXPECT_EQ(answer_of("sh -c 'read x; printf \"one\\ntwo\\n\"'").error(),
            "expected one line as answer, got more: 'two'");
  EXPECT_EQ(answer_of("sh -c 'read x; head -c 200000 /dev/zero'").error(),
            "expected a line of at most 65536 bytes as answer, got more");
}

TEST(Process, UnaskedOutputIsNoAnswer) {
  const tests::TemporaryFolder folder;
  const std::string said = folder / "said";
  auto process = Process::start("sh -c 'read x; echo one; echo two; >" + said + "; read x; echo three'");
  ASSERT_TRUE(process);
  const auto first = process->ask("hello\n", kPatience);
  ASSERT_TRUE(tests::eventually([&] { return std::filesystem::exists(said); }));
  // the second line came along with the first one, or is found before the next question
  const auto answer = first ? process->ask("hello\n", kPatience) : first;
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error(), "expected one line as answer, got more: 'two'");
}

TEST(Process, EndsWithItsObject) {
  std::string pid;
  {
    auto process = Process::start("sh -c 'read x; echo $$; sleep 60'");
    ASSERT_TRUE(process);
    const auto answer = process->ask("who\n", kPatience);
    ASSERT_TRUE(answer);
    pid = *answer;
  }
  EXPECT_NE(kill(std::stoi(pid), 0), 0);
}

}  // namespace
}  // namespace sim::guest
