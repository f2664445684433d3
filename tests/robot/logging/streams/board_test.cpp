// Loggers, parsers and the board that starts and stops them.
#include "robot/logging/streams/board.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <future>
#include <iterator>
#include <new>

#include "tests/support/eventually.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

using tests::Arrivals;
using tests::KeepingProvider;

enum class Kind { own_thread, pooled };

/// A board whose loggers are of the kind that the parameter names.
struct Board : ::testing::TestWithParam<Kind> {
  LoggingBoard::StreamId log(std::size_t queue_bytes = LoggingBoard::kQueueBytes) {
    return log(channel, arrivals, queue_bytes);
  }
  LoggingBoard::StreamId log(const std::shared_ptr<memory::Channel>& from, const std::shared_ptr<Arrivals>& to,
                             std::size_t queue_bytes = LoggingBoard::kQueueBytes) {
    auto provider = std::make_unique<KeepingProvider>(to);
    return GetParam() == Kind::pooled ? board.start_pooled(from, std::move(provider), queue_bytes)
                                      : board.start_logger(from, std::move(provider), queue_bytes);
  }
  void write(std::string_view bytes, std::uint64_t capture_ns = 1) {
    ASSERT_TRUE(channel->write_bytes(bytes, capture_ns));
  }

  ManualClock clock{50};
  std::shared_ptr<memory::RawChannel> channel = tests::make_channel(clock);
  std::shared_ptr<Arrivals> arrivals = std::make_shared<Arrivals>();
  LoggingBoard board;
};

TEST_P(Board, LoggerCarriesEveryVersionWithItsNumberAndTimes) {
  const auto stream = log();
  write("one", 10);
  write("two", 20);
  const StreamStatus status = board.stop(stream);
  ASSERT_EQ(arrivals->records.size(), 2u);
  EXPECT_EQ(arrivals->records[1], (Record{.sequence = 2, .capture_ns = 20, .publish_ns = 50, .bytes = "two"}));
  EXPECT_EQ(status.messages, 2u);
  EXPECT_EQ(status.dropped, 0u);
  EXPECT_TRUE(status.ended);
  EXPECT_TRUE(arrivals->closed);
}

TEST_P(Board, LoggerBeginsWithTheNewestVersion) {
  write("before");
  const auto stream = log();
  board.stop(stream);
  ASSERT_EQ(arrivals->records.size(), 1u);
  EXPECT_EQ(arrivals->records[0].bytes, "before");
}

TEST_P(Board, StreamsStartAndStopAtAnyTime) {
  for (std::uint64_t round = 0; round < 50; ++round) {
    const auto stream = log();
    write("x");
    EXPECT_EQ(board.stop(stream).dropped, 0u);
  }
  EXPECT_TRUE(board.statuses().empty());
}

TEST_P(Board, ASlowDeviceNeverBlocksTheWriterAndLostMessagesAreCounted) {
  arrivals->blocked = true;
  const auto stream = log(100);
  constexpr std::uint64_t kWrites = 1000;
  for (std::uint64_t i = 0; i < kWrites; ++i) write("0123456789");
  arrivals->set(&Arrivals::blocked, false);
  const StreamStatus status = board.stop(stream);
  EXPECT_GT(status.dropped, 0u);
  EXPECT_EQ(status.messages + status.dropped, kWrites);
  EXPECT_EQ(arrivals->records.back().sequence, kWrites) << "the newest is kept";
}

TEST_P(Board, AFailingDeviceIsReportedAndTriedAgain) {
  arrivals->refuse = true;
  const auto stream = log();
  write("lost");
  ASSERT_TRUE(tests::eventually([&] { return board.status(stream).failing; }));
  EXPECT_EQ(board.status(stream).problem, "test device: expected to work, was told to fail");
  arrivals->set(&Arrivals::refuse, false);
  write("kept");
  const StreamStatus status = board.stop(stream);
  EXPECT_EQ(status.dropped, 1u);
  EXPECT_EQ(status.messages, 1u);
  EXPECT_FALSE(status.failing);
  EXPECT_EQ(status.problem, "");
}

/// A device with a buffer: write() collects, flush() fails while the disk is full.
class BufferedProvider final : public OutProvider {
 public:
  explicit BufferedProvider(std::shared_ptr<std::atomic<bool>> full) : full_(std::move(full)) {}
  Result<void> open(const memory::ChannelInfo&) override { return {}; }
  Result<void> write(const memory::VersionPtr&) override {
    if (due_ns_ == kNever) due_ns_ = monotonic_ns() + 50 * kMillisecond;
    return {};
  }
  std::uint64_t flush_due_ns() const override { return due_ns_; }
  Result<void> flush() override {
    due_ns_ = kNever;
    return *full_ ? Result<void>(Error{"test device: full"}) : Result<void>();
  }
  Result<void> close() override { return {}; }

 private:
  const std::shared_ptr<std::atomic<bool>> full_;
  std::uint64_t due_ns_ = kNever;
};

// a full disk once showed as healthy in every sample, because the buffer took each message
TEST(BoardBuffer, AFailureLastsUntilTheDeviceHasTakenTheBuffer) {
  ManualClock clock;
  LoggingBoard board;
  const auto channel = tests::make_channel(clock);
  const auto full = std::make_shared<std::atomic<bool>>(true);
  const auto stream = board.start_logger(channel, std::make_unique<BufferedProvider>(full));
  ASSERT_TRUE(channel->write_bytes("lost", 1));
  ASSERT_TRUE(tests::eventually([&] { return board.status(stream).failing; }));
  const std::uint64_t failed_ns = board.status(stream).failed_ns;
  ASSERT_TRUE(tests::eventually([&] {  // the next flush fails, too
    EXPECT_TRUE(channel->write_bytes("lost", 2));
    EXPECT_TRUE(board.status(stream).failing);
    EXPECT_EQ(board.status(stream).problem, "test device: full");
    return board.status(stream).failed_ns != failed_ns;
  }));
  *full = false;
  ASSERT_TRUE(channel->write_bytes("kept", 3));
  ASSERT_TRUE(tests::eventually([&] { return !board.status(stream).failing; }));
  EXPECT_EQ(board.status(stream).problem, "");
  EXPECT_GT(board.status(stream).delivered_ns, board.status(stream).failed_ns);
}

/// A device for which there is no memory, once for each of its functions.
class ThrowingProvider final : public OutProvider {
 public:
  Result<void> open(const memory::ChannelInfo&) override { return once(opens_); }
  Result<void> write(const memory::VersionPtr&) override { return once(writes_); }
  Result<void> close() override { return once(closes_); }

 private:
  static Result<void> once(int& calls) {
    if (calls++ == 0) throw std::bad_alloc();
    return {};
  }

  int opens_ = 0, writes_ = 0, closes_ = 0;
};

TEST(BoardWithoutMemory, AnExceptionOfTheDeviceCostsOneVersion) {
  ManualClock clock;
  LoggingBoard board;
  const auto channel = tests::make_channel(clock);
  const auto stream = board.start_logger(channel, std::make_unique<ThrowingProvider>());
  ASSERT_TRUE(channel->write_bytes("no device yet", 1));
  ASSERT_TRUE(tests::eventually([&] { return board.status(stream).dropped == 1; }));
  EXPECT_EQ(board.status(stream).problem, "writing to a device failed: std::bad_alloc");
  ASSERT_TRUE(tests::eventually([&] {  // it opens again after a second; then the first write fails
    EXPECT_TRUE(channel->write_bytes("next", 2));
    return board.status(stream).messages > 0;
  }));
  const StreamStatus last = board.stop(stream);
  EXPECT_TRUE(last.ended);
  EXPECT_FALSE(last.failing) << "the device was closed with the second attempt";
}

TEST_P(Board, AStreamThatNobodyWritesStillOpensAndClosesItsDevice) {
  board.stop(log());
  EXPECT_TRUE(arrivals->closed);
  EXPECT_TRUE(arrivals->records.empty());
}

TEST_P(Board, ABlockedDeviceDelaysNoOtherStream) {
  arrivals->blocked = true;
  const auto blocked = log();
  write("waits");
  const auto other_channel = tests::make_channel(clock);
  const auto other = std::make_shared<Arrivals>();
  const auto stream = log(other_channel, other);
  for (std::size_t i = 1; i <= 5; ++i) {
    ASSERT_TRUE(other_channel->write_bytes("passes", i));
    other->wait_for(i);
  }
  board.stop(blocked);  // ends the blocked write
  board.stop(stream);
  EXPECT_EQ(arrivals->records.size(), 1u);
}

// more streams than threads of a pool: each version arrives once, in the order of its stream
TEST_P(Board, ManyStreamsKeepTheirOrderAndLoseNothing) {
  constexpr std::size_t kStreams = 20, kWrites = 200;
  std::vector<std::shared_ptr<memory::RawChannel>> channels;
  std::vector<std::shared_ptr<Arrivals>> kept;
  std::vector<LoggingBoard::StreamId> streams;
  for (std::size_t i = 0; i < kStreams; ++i) {
    channels.push_back(tests::make_channel(clock));
    kept.push_back(std::make_shared<Arrivals>());
    streams.push_back(log(channels[i], kept[i]));
  }
  for (std::size_t n = 1; n <= kWrites; ++n)
    for (const auto& one : channels) ASSERT_TRUE(one->write_bytes("x", n));
  for (std::size_t i = 0; i < kStreams; ++i) {
    if (i % 2 == 0) kept[i]->wait_for(kWrites);  // the others are stopped while they work
    EXPECT_EQ(board.stop(streams[i]).messages, kWrites);
    ASSERT_EQ(kept[i]->records.size(), kWrites);
    for (std::size_t n = 0; n < kWrites; ++n) EXPECT_EQ(kept[i]->records[n].sequence, n + 1);
  }
}

TEST_P(Board, StoppingAnUnknownStreamHasNoEffect) { EXPECT_EQ(board.stop(99).topic, ""); }

INSTANTIATE_TEST_SUITE_P(Loggers, Board, ::testing::Values(Kind::own_thread, Kind::pooled),
                         [](const auto& test) { return test.param == Kind::pooled ? "Pooled" : "OwnThread"; });

/// The number of threads of this process, as the system counts them.
std::size_t threads() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

TEST(BoardThreads, PooledStreamsShareAFewThreadsAndAnUnwrittenLoggerHasNone) {
  ManualClock clock;
  LoggingBoard board;
  std::vector<LoggingBoard::StreamId> streams;
  const auto start = [&](bool pooled) {
    const auto channel = tests::make_channel(clock);
    if (pooled) {
      EXPECT_TRUE(channel->write_bytes("x", 1));
    }
    auto provider = std::make_unique<KeepingProvider>(std::make_shared<Arrivals>());
    streams.push_back(pooled ? board.start_pooled(channel, std::move(provider))
                             : board.start_logger(channel, std::move(provider)));
  };
  start(true);  // starts the bell and the threads of the pool
  const std::size_t with_one = threads();
  EXPECT_GE(with_one, 1 + LoggerPool::kThreads + 1);
  for (int i = 0; i < 30; ++i) start(true);
  for (int i = 0; i < 30; ++i) start(false);
  EXPECT_EQ(threads(), with_one);
  for (const auto stream : streams) board.stop(stream);
}

struct ParserBoard : ::testing::Test {
  ManualClock clock{50};
  std::shared_ptr<memory::RawChannel> channel = tests::make_channel(clock);
  std::shared_ptr<Arrivals> arrivals = std::make_shared<Arrivals>();
  LoggingBoard board;
};

/// An input stream of given records.
class GivenProvider final : public InProvider {
 public:
  explicit GivenProvider(std::vector<Record> records) : records_(std::move(records)) {}
  Result<memory::ChannelInfo> open() override { return memory::ChannelInfo{.topic = "/14/2/given"}; }
  Result<std::optional<Record>> read() override {
    if (next_ == records_.size()) return std::optional<Record>();
    return std::optional<Record>(records_[next_++]);
  }

 private:
  std::vector<Record> records_;
  std::size_t next_ = 0;
};

TEST_F(ParserBoard, CarriesAStreamIntoAChannelToItsEnd) {
  const auto log_stream = board.start_logger(channel, std::make_unique<KeepingProvider>(arrivals));
  std::promise<std::string> topic;
  const auto stream = board.start_parser(
      std::make_unique<GivenProvider>(
          std::vector<Record>{{.capture_ns = 1, .bytes = "a"}, {.capture_ns = 2, .bytes = "b"}}),
      {.destination = [&](const memory::ChannelInfo& info) -> Result<std::shared_ptr<memory::Channel>> {
         topic.set_value(info.topic);
         return std::shared_ptr<memory::Channel>(channel);
       },
       .pace = nullptr});
  EXPECT_EQ(topic.get_future().get(), "/14/2/given");
  arrivals->wait_for(2);
  board.stop(log_stream);
  const StreamStatus status = board.stop(stream);
  EXPECT_EQ(status.messages, 2u);
  EXPECT_TRUE(status.ended);
  EXPECT_EQ(arrivals->records[1].bytes, "b");
  EXPECT_EQ(arrivals->records[1].capture_ns, 2u);
}

TEST_F(ParserBoard, WithoutADestinationEndsWithTheReason) {
  const auto stream =
      board.start_parser(std::make_unique<GivenProvider>(std::vector<Record>{{.bytes = "a"}}),
                         {.destination = [](const memory::ChannelInfo&) -> Result<std::shared_ptr<memory::Channel>> {
                            return Error{"no channel for it"};
                          },
                          .pace = nullptr});
  ASSERT_TRUE(tests::eventually([&] { return board.status(stream).ended; }));
  EXPECT_EQ(board.stop(stream).problem, "no channel for it");
}

}  // namespace
}  // namespace robot::logging
