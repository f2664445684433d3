#include "robot/logging/sessions/session_counter.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <thread>
#include <vector>

#include "robot/core/lock.h"
#include "tests/support/temporary_folder.h"

namespace robot::logging {
namespace {

TEST(SessionCounter, CountsUp) {
  const tests::TemporaryFolder folder;
  EXPECT_EQ(next_session_number(folder.path(), 0), 1u);
  EXPECT_EQ(next_session_number(folder.path(), 0), 2u);
  EXPECT_EQ(next_session_number(folder.path(), 9), 10u);
  EXPECT_EQ(next_session_number(folder.path(), 3), 11u);
}

TEST(SessionCounter, ADamagedOrMissingFileCountsAsZero) {
  const tests::TemporaryFolder folder;
  for (const char* text : {"", "x", "-1", "99999999999999999999999999", "18446744073709551615"}) {
    std::ofstream(folder / kCounterFile, std::ios::trunc) << text;
    EXPECT_EQ(next_session_number(folder.path(), 4), 5u) << text;
  }
  EXPECT_EQ(next_session_number(folder / "none", 4), 5u);
}

TEST(SessionCounter, GivesEachNumberOnce) {
  const tests::TemporaryFolder folder;
  Mutex lock;
  std::multiset<std::uint64_t> numbers;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int n = 0; n < 25; ++n) {
        const std::uint64_t number = next_session_number(folder.path(), 0);
        const std::lock_guard guard(lock);
        numbers.insert(number);
      }
    });
  for (std::thread& thread : threads) thread.join();
  ASSERT_EQ(numbers.size(), 100u);
  for (std::uint64_t number = 1; number <= 100; ++number) EXPECT_EQ(numbers.count(number), 1u);
}

TEST(Boot, HasOneIdentityWhileTheMachineRuns) {
  EXPECT_EQ(boot_id().size(), 36u);
  EXPECT_EQ(boot_id(), boot_id());
}

}  // namespace
}  // namespace robot::logging
