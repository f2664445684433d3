// The recent past of a process: which versions it holds, from any thread.
#include "robot/logging/recent/recent_past.h"

#include <gtest/gtest.h>

#include <map>

#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/reader.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

using Counts = std::map<std::string, std::uint64_t>;  // of messages, by topic

Counts counts_of(RecentPast& past) {
  const auto file = past.file();
  EXPECT_TRUE(file) << (file ? "" : file.error());
  if (!file) return {};
  const auto index = read_index(**file);
  EXPECT_TRUE(index && index->damage.empty());
  McapReader reader(*file);
  Counts counts;
  for (auto message = reader.next(); message && *message; message = reader.next())
    ++counts[index->channels.at((*message)->channel_id).topic];
  return counts;
}

struct Past : ::testing::Test {
  std::shared_ptr<memory::RawChannel> add(const std::string& topic, const std::string& schema = "test.Bytes") {
    auto channel = std::make_shared<memory::RawChannel>(
        memory::ChannelInfo{.topic = topic, .message_encoding = "protobuf", .schema = {schema, "protobuf", ""}}, clock);
    EXPECT_TRUE(channels.add(channel));
    return channel;
  }

  ManualClock clock{50};
  memory::Channels channels;
};

TEST_F(Past, HoldsEveryVersionThatWasWrittenBeforeTheCall) {
  const auto early = add("/early");
  ASSERT_TRUE(early->write_bytes("newest", 1));
  RecentPast past(channels);
  const auto late = add("/late");
  for (std::uint64_t i = 2; i <= 200; ++i)
    for (const auto& channel : {early, late}) ASSERT_TRUE(channel->write_bytes("x", i));
  EXPECT_EQ(counts_of(past), (Counts{{"/early", 200}, {"/late", 199}}));
  ASSERT_TRUE(late->write_bytes("x", 300));
  EXPECT_EQ(counts_of(past), (Counts{{"/early", 200}, {"/late", 200}}));
}

TEST_F(Past, LeavesOutImagesAndLargeMessages) {
  const auto camera = add("/camera", "foresight.Image"), foreign = add("/foreign", "foxglove.CompressedImage");
  const auto mixed = add("/mixed");
  RecentPast past(channels, {.file = {}, .message_bytes = 100, .queue_bytes = 1024});
  for (const auto& channel : {camera, foreign, mixed}) {
    ASSERT_TRUE(channel->write_bytes(std::string(100, 'x'), 1));
    ASSERT_TRUE(channel->write_bytes(std::string(101, 'x'), 2));
  }
  EXPECT_EQ(counts_of(past), (Counts{{"/mixed", 1}}));
}

TEST_F(Past, CountsTheVersionsThatAFullQueueLeavesOut) {
  const auto channel = add("/burst");
  RecentPast past(channels, {.file = {}, .queue_bytes = 1024});
  constexpr std::uint64_t kWritten = 20'000;
  for (std::uint64_t i = 1; i <= kWritten; ++i) ASSERT_TRUE(channel->write_bytes(std::string(100, 'x'), i));
  const std::uint64_t held = counts_of(past)["/burst"];
  EXPECT_GT(held, 0u);
  EXPECT_GT(past.dropped(), 0u);
  EXPECT_EQ(held + past.dropped(), kWritten);
}

TEST_F(Past, ManyThreadsMayWriteAndAsk) {
  std::vector<std::shared_ptr<memory::RawChannel>> all;
  for (int i = 0; i < 4; ++i) all.push_back(add("/" + std::to_string(i)));
  RecentPast past(channels);
  std::vector<std::thread> threads;
  for (const auto& channel : all)
    threads.emplace_back([channel] {
      for (std::uint64_t i = 1; i <= 500; ++i) ASSERT_TRUE(channel->write_bytes("x", i));
    });
  for (int i = 0; i < 2; ++i)
    threads.emplace_back([&past] {
      std::uint64_t before = 0;
      for (int asked = 0; asked < 20; ++asked) {
        std::uint64_t sum = 0;
        for (const auto& [topic, count] : counts_of(past)) sum += count;
        EXPECT_GE(sum, before);
        before = sum;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(counts_of(past), (Counts{{"/0", 500}, {"/1", 500}, {"/2", 500}, {"/3", 500}}));
}

}  // namespace
}  // namespace robot::logging
