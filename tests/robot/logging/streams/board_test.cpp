// Loggers, parsers and the board that starts and stops them.
#include "robot/logging/streams/board.h"

#include <gtest/gtest.h>

#include <future>

#include "tests/support/eventually.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

using tests::Arrivals;
using tests::KeepingProvider;

struct Board : ::testing::Test {
  LoggingBoard::StreamId log(std::size_t queue_bytes = LoggingBoard::kQueueBytes) {
    return board.start_logger(channel, std::make_unique<KeepingProvider>(arrivals), queue_bytes);
  }
  void write(std::string_view bytes, std::uint64_t capture_ns = 1) {
    ASSERT_TRUE(channel->write_bytes(bytes, capture_ns));
  }

  ManualClock clock{50};
  std::shared_ptr<memory::RawChannel> channel = tests::make_channel(clock);
  std::shared_ptr<Arrivals> arrivals = std::make_shared<Arrivals>();
  LoggingBoard board;
};

TEST_F(Board, LoggerCarriesEveryVersionWithItsNumberAndTimes) {
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

TEST_F(Board, LoggerBeginsWithTheNewestVersion) {
  write("before");
  const auto stream = log();
  board.stop(stream);
  ASSERT_EQ(arrivals->records.size(), 1u);
  EXPECT_EQ(arrivals->records[0].bytes, "before");
}

TEST_F(Board, StreamsStartAndStopAtAnyTime) {
  for (std::uint64_t round = 0; round < 50; ++round) {
    const auto stream = log();
    write("x");
    EXPECT_EQ(board.stop(stream).dropped, 0u);
  }
  EXPECT_TRUE(board.statuses().empty());
}

TEST_F(Board, ASlowDeviceNeverBlocksTheWriterAndLostMessagesAreCounted) {
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

TEST_F(Board, AFailingDeviceIsReportedAndTriedAgain) {
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

TEST_F(Board, StoppingAnUnknownStreamHasNoEffect) { EXPECT_EQ(board.stop(99).topic, ""); }

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

TEST_F(Board, ParserCarriesAStreamIntoAChannelToItsEnd) {
  const auto log_stream = log();
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

TEST_F(Board, ParserWithoutADestinationEndsWithTheReason) {
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
