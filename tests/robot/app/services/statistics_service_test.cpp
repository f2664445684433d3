#include "robot/app/services/statistics_service.h"

#include <gtest/gtest.h>

#include "robot/memory/memory.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_channel.h"

namespace robot::app {
namespace {

struct StatisticsOfAProcess : ::testing::Test {
  StatisticsOfAProcess() { EXPECT_TRUE(channels.add(channel)); }

  const tests::TemporaryFolder folder;
  ManualClock clock{1000};
  std::shared_ptr<memory::RawChannel> channel = tests::make_channel(clock, "/14/2/x");
  memory::Channels channels;
  logging::LoggingBoard board;
  logging::SessionStore store{folder.path(), 1'000'000'000};
  StatisticsService statistics{channels, clock, board, store, nullptr};
};

TEST_F(StatisticsOfAProcess, ReportsEachStream) {
  EXPECT_FALSE(statistics.collect({}).streams(0).has_age_ns()) << "never written";
  ASSERT_TRUE(channel->write_bytes("12345", 600));
  const auto stream = statistics.collect({}).streams(0);
  EXPECT_EQ(stream.topic(), "/14/2/x");
  EXPECT_EQ(stream.count(), 1u);
  EXPECT_EQ(stream.size_bytes(), 5u);
  EXPECT_EQ(stream.age_ns(), 400u);
  EXPECT_GT(stream.rate_hz(), 0);
  EXPECT_EQ(statistics.collect({}).streams(0).rate_hz(), 0) << "no message since the last call";
}

TEST_F(StatisticsOfAProcess, ReportsLoggersAndTheirLosses) {
  const auto arrivals = std::make_shared<tests::Arrivals>();
  arrivals->blocked = true;
  const auto logger = board.start_logger(channel, std::make_unique<tests::KeepingProvider>(arrivals), 10);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(channel->write_bytes("0123456789", 1));
  EXPECT_GE(statistics.collect({}).loggers(0).dropped(), 98u);
  arrivals->set(&tests::Arrivals::blocked, false);
  board.stop(logger);
}

TEST_F(StatisticsOfAProcess, ReportsTheClientsOfTheServer) {
  const auto client = statistics
                          .collect({.clients = {{.id = 7,
                                                 .address = "10.0.14.9:5000",
                                                 .round_trip_ns = 3'000'000,
                                                 .lossless = true,
                                                 .channels = {{.topic = "/14/2/x", .sent = 5, .dropped = 2}}}}})
                          .clients(0);
  EXPECT_EQ(client.id(), 7u);
  EXPECT_EQ(client.round_trip_ns(), 3'000'000u);
  EXPECT_TRUE(client.lossless());
  EXPECT_EQ(client.channels(0).dropped(), 2u);
}

TEST_F(StatisticsOfAProcess, ReportsTheProcessAndTheDisk) {
  const auto process = statistics.collect({}).process();
  EXPECT_GT(process.resident_bytes(), 1'000'000u);
  EXPECT_GT(process.disk_free_bytes(), 0u);
}

TEST_F(StatisticsOfAProcess, WithoutARecorderTheRecordingIsOff) {
  EXPECT_EQ(statistics.collect({}).recording().state(), foresight::RuntimeStatistics::Recording::STATE_OFF);
}

}  // namespace
}  // namespace robot::app
