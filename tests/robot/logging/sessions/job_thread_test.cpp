#include "robot/logging/sessions/job_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <new>

#include "robot/core/clock.h"
#include "tests/support/eventually.h"

namespace robot::logging {
namespace {

constexpr std::uint64_t kMinute = 60 * kSecond;

TEST(JobThread, DoesTheJobsBeforeItReturnsIfThereIsTime) {
  std::string done;
  JobThread jobs([&](const std::string& name) { done += name; });
  jobs.add({"a", "b"}, kMinute);
  EXPECT_EQ(done, "ab");
  jobs.add({"a"}, kMinute);
  EXPECT_EQ(done, "aba");
}

TEST(JobThread, NobodyWaitsLongerForALongJob) {
  std::promise<void> end;
  std::string done;
  JobThread jobs([&, ended = end.get_future().share()](const std::string& name) {
    if (name == "long ") ended.wait();
    done += name;
  });
  jobs.add({"long "}, 0);
  jobs.add({"short "}, kMillisecond);
  jobs.add({"short "}, 0);  // waits already
  end.set_value();
  jobs.add({"last"}, kMinute);
  EXPECT_EQ(done, "long short last");
}

TEST(JobThread, AJobThatRunsIsDoneAgainForALaterCall) {
  std::promise<void> end;
  std::atomic<int> begun = 0;
  JobThread jobs([&, ended = end.get_future().share()](const std::string&) {
    if (++begun == 1) ended.wait();
  });
  jobs.add({"a"}, 0);
  ASSERT_TRUE(tests::eventually([&] { return begun == 1; }));
  end.set_value();
  jobs.add({"a"}, kMinute);
  EXPECT_EQ(begun, 2) << "the first one may have read an older state";
}

TEST(JobThread, AnExceptionEndsOnlyItsJob) {
  int done = 0;
  JobThread jobs([&](const std::string& name) {
    if (name == "bad") throw std::bad_alloc();
    ++done;
  });
  jobs.add({"bad", "good"}, kMinute);
  EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace robot::logging
