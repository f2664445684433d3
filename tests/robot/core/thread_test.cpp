// Threads that the system refuses: nothing ends, nothing is lost without being counted, and the work begins later.
#include "robot/core/thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>

#include "robot/core/attempt.h"
#include "robot/logging/streams/board.h"
#include "tests/support/eventually.h"
#include "tests/support/refused_threads.h"
#include "tests/support/test_channel.h"

namespace robot {
namespace {

constexpr int kAll = 1'000'000;

struct RefusedThreads : ::testing::Test {
  void SetUp() override {
    if (!tests::kCanRefuseThreads) GTEST_SKIP() << "the sanitizer starts the threads of this program";
  }
  ~RefusedThreads() override { tests::refuse_threads(0); }

  /// Writes versions and expects all of them in `arrivals`, once the system allows threads again.
  void expect_all_later(logging::LoggingBoard::StreamId stream) {
    for (const char* bytes : {"one", "two", "three"}) ASSERT_TRUE(channel->write_bytes(bytes, 1));
    ASSERT_TRUE(tests::eventually([] { return tests::refused_threads() > 0; }));
    EXPECT_EQ(board.status(stream).messages, 0u);
    tests::refuse_threads(0);
    ASSERT_TRUE(tests::eventually([&] {
      board.start_missing_threads();
      return board.status(stream).messages == 3;
    }));
    EXPECT_EQ(board.stop(stream).dropped, 0u);
    EXPECT_EQ(arrivals->records.size(), 3u);
  }

  ManualClock clock{50};
  std::shared_ptr<memory::RawChannel> channel = tests::make_channel(clock);
  std::shared_ptr<tests::Arrivals> arrivals = std::make_shared<tests::Arrivals>();
  logging::LoggingBoard board;
};

TEST_F(RefusedThreads, AreReportedByTheirPurpose) {
  std::thread thread;
  tests::refuse_threads(1);
  const Result<void> refused = start_thread(thread, "door", [] {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), "cannot start the thread 'door': Resource temporarily unavailable");
  EXPECT_FALSE(thread.joinable());

  std::atomic<bool> ran = false;
  ASSERT_TRUE(start_thread(thread, "door", [&] { ran = true; }));
  thread.join();
  EXPECT_TRUE(ran);
}

TEST_F(RefusedThreads, ALoggerBeginsLater) {
  const auto other = board.start_logger(tests::make_channel(clock),
                                        std::make_unique<tests::KeepingProvider>(std::make_shared<tests::Arrivals>()));
  tests::refuse_threads(kAll);  // the bell runs
  expect_all_later(board.start_logger(channel, std::make_unique<tests::KeepingProvider>(arrivals)));
  board.stop(other);
}

TEST_F(RefusedThreads, TheBellBeginsLater) {
  tests::refuse_threads(kAll);
  expect_all_later(board.start_logger(channel, std::make_unique<tests::KeepingProvider>(arrivals)));
}

TEST_F(RefusedThreads, WatchedStreamsBeginLater) {
  tests::refuse_threads(kAll);
  expect_all_later(board.start_pooled(channel, std::make_unique<tests::KeepingProvider>(arrivals)));
}

TEST_F(RefusedThreads, ALoggerThatNeverGotAThreadWritesWhenItStops) {
  tests::refuse_threads(kAll);
  const auto stream = board.start_logger(channel, std::make_unique<tests::KeepingProvider>(arrivals));
  ASSERT_TRUE(channel->write_bytes("last", 1));
  EXPECT_EQ(board.stop(stream).messages, 1u);
}

TEST_F(RefusedThreads, AParserEndsWithTheReason) {
  struct Empty final : logging::InProvider {
    Result<memory::ChannelInfo> open() override { return Error{"never opened"}; }
    Result<std::optional<logging::Record>> read() override { return std::optional<logging::Record>(); }
    Result<void> seek(std::uint64_t) override { return {}; }
  };
  tests::refuse_threads(1);
  const auto stream = board.start_parser(std::make_unique<Empty>(), {.destination = {}, .pace = nullptr});
  EXPECT_TRUE(board.status(stream).ended);
  EXPECT_EQ(board.stop(stream).problem, "cannot start the thread 'parser': Resource temporarily unavailable");
}

TEST(Attempt, TurnsExceptionsIntoErrors) {
  EXPECT_TRUE(attempt("work", [] {}));
  EXPECT_EQ(attempt("work", [] { throw std::bad_alloc(); }).error(), "work failed: std::bad_alloc");
  EXPECT_EQ(attempt("work", []() -> Result<void> { return Error{"a reason"}; }).error(), "a reason");
  EXPECT_TRUE(attempt("work", []() -> Result<void> { return {}; }));
}

}  // namespace
}  // namespace robot
