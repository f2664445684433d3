// The recent file: what it holds, what it forgets, and that it is a whole MCAP file at any time.
#include "robot/logging/recent/recent_file.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/reader.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

using Messages = std::map<std::string, std::vector<Record>>;  // by topic, in the order of the file

memory::ChannelInfo channel(const std::string& topic) {
  return {.topic = topic, .message_encoding = "protobuf", .schema = {"test.Bytes", "protobuf", "description"}};
}

/// Reads the file as any program would, and requires it to be whole.
Messages messages_of(RecentFile& recent, std::vector<std::string> topics = {}) {
  const auto file = recent.file(topics);
  EXPECT_TRUE(file) << (file ? "" : file.error());
  if (!file) return {};
  const auto index = read_index(**file);
  EXPECT_TRUE(index && index->damage.empty());
  McapReader reader(*file);
  Messages messages;
  for (;;) {
    auto message = reader.next();
    EXPECT_TRUE(message) << (message ? "" : message.error());
    if (!message || !*message) return messages;
    messages[index->channels.at((*message)->channel_id).topic].push_back(std::move((*message)->record));
  }
}

std::vector<std::uint64_t> times_of(const std::vector<Record>& records) {
  std::vector<std::uint64_t> times;
  for (const Record& record : records) times.push_back(record.capture_ns);
  return times;
}

/// Writes a message at each time, numbered from 1.
void write(RecentFile& recent, std::size_t channel, const std::vector<std::uint64_t>& times,
           const std::string& bytes = "bytes") {
  std::uint64_t sequence = 0;
  for (const std::uint64_t time_ns : times)
    ASSERT_TRUE(recent.write(channel, {++sequence, time_ns, time_ns + 1, bytes}));
}

std::vector<std::uint64_t> every(std::uint64_t step_ns, std::uint64_t from_ns, std::uint64_t to_ns) {
  std::vector<std::uint64_t> times;
  for (std::uint64_t time_ns = from_ns; time_ns <= to_ns; time_ns += step_ns) times.push_back(time_ns);
  return times;
}

TEST(RecentFile, HoldsEveryMessageOfEachChannelAsItWasWritten) {
  RecentFile recent;
  const std::size_t ball = recent.add(channel("/14/2/ball")), pose = recent.add(channel("/14/2/pose"));
  for (std::uint64_t i = 1; i <= 3000; ++i) {
    ASSERT_TRUE(recent.write(ball, {i, i * 33 * kMillisecond, i * 33 * kMillisecond + 7, "ball" + std::to_string(i)}));
    ASSERT_TRUE(recent.write(pose, {2 * i, i * 33 * kMillisecond, i, "pose" + std::to_string(i)}));
  }
  Messages messages = messages_of(recent);
  ASSERT_EQ(messages["/14/2/ball"].size(), 3000u);
  ASSERT_EQ(messages["/14/2/pose"].size(), 3000u);
  for (std::uint64_t i = 1; i <= 3000; ++i) {
    const std::uint64_t time_ns = i * 33 * kMillisecond;
    EXPECT_EQ(
        messages["/14/2/ball"][i - 1],
        (Record{.sequence = i, .capture_ns = time_ns, .publish_ns = time_ns + 7, .bytes = "ball" + std::to_string(i)}));
    EXPECT_EQ(messages["/14/2/pose"][i - 1],
              (Record{.sequence = 2 * i, .capture_ns = time_ns, .publish_ns = i, .bytes = "pose" + std::to_string(i)}));
  }
}

TEST(RecentFile, GivesTheMessagesOfSomeTopicsAlone) {
  RecentFile recent;
  const std::size_t ball = recent.add(channel("/ball")), pose = recent.add(channel("/pose"));
  write(recent, ball, {1, 2, 3});
  write(recent, pose, {1, 2});
  EXPECT_EQ(times_of(messages_of(recent, {"/pose"})["/pose"]), (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(messages_of(recent, {"/pose"}).size(), 1u);
  EXPECT_EQ(messages_of(recent, {"/pose", "/none", "/ball"}).size(), 2u);
  EXPECT_TRUE(messages_of(recent, {"/none"}).empty());
}

TEST(RecentFile, IsAWholeFileWithoutChannelsAndWithoutMessages) {
  RecentFile recent;
  EXPECT_TRUE(messages_of(recent).empty());
  recent.add(channel("/14/2/ball"));
  EXPECT_TRUE(messages_of(recent).empty());
}

TEST(RecentFile, ForgetsWhatIsOlderThanItsAgeButNotTheOnlyValueOfAnObject) {
  RecentFile recent({.age_ns = 60 * kSecond, .chunk_ns = kSecond});
  const std::size_t ball = recent.add(channel("/ball")), calibration = recent.add(channel("/calibration"));
  write(recent, calibration, {5 * kSecond});
  write(recent, ball, every(kSecond / 10, kSecond, 500 * kSecond));
  Messages messages = messages_of(recent);
  EXPECT_EQ(times_of(messages["/calibration"]), std::vector<std::uint64_t>{5 * kSecond});
  const std::vector<std::uint64_t> times = times_of(messages["/ball"]);
  EXPECT_EQ(times.back(), 500 * kSecond);
  EXPECT_LE(times.front(), 440 * kSecond);
  EXPECT_GE(times.front(), 438 * kSecond);  // a chunk goes when its last message is too old
  EXPECT_EQ(times, every(kSecond / 10, times.front(), 500 * kSecond)) << "nothing between is missing";
}

TEST(RecentFile, StaysWithinItsBytes) {
  constexpr std::size_t kBytes = 100'000, kChunk = 4096;
  RecentFile recent({.bytes = kBytes, .chunk_bytes = kChunk});
  const std::size_t first = recent.add(channel("/first")), second = recent.add(channel("/second"));
  std::minstd_rand random(7);
  std::size_t most = 0;
  for (std::uint64_t i = 1; i <= 4000; ++i) {
    std::string bytes(100 + random() % 400, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    ASSERT_TRUE(recent.write(random() % 4 == 0 ? second : first, {i, i * kMillisecond, i, bytes}));
    most = std::max(most, recent.size_bytes());
  }
  EXPECT_LE(most, kBytes + 2 * kChunk);
  Messages messages = messages_of(recent);
  EXPECT_EQ(std::max(messages["/first"].back().sequence, messages["/second"].back().sequence), 4000u);
  EXPECT_GT(most, kBytes / 2);
}

TEST(RecentFile, AChannelWhoseTimeGoesBackBeginsAnewAndLeavesTheOthersAlone) {
  RecentFile recent({.chunk_ns = kSecond});
  const std::size_t ball = recent.add(channel("/ball")), pose = recent.add(channel("/pose"));
  write(recent, ball, every(kSecond / 10, 100 * kSecond, 110 * kSecond));
  write(recent, pose, every(kSecond / 10, 100 * kSecond, 110 * kSecond));
  write(recent, ball, every(kSecond / 10, 50 * kSecond, 52 * kSecond));
  Messages messages = messages_of(recent);
  EXPECT_EQ(times_of(messages["/ball"]), every(kSecond / 10, 50 * kSecond, 52 * kSecond));
  EXPECT_EQ(times_of(messages["/pose"]), every(kSecond / 10, 100 * kSecond, 110 * kSecond));
}

TEST(RecentFile, AMessageThatIsALittleLateStays) {
  RecentFile recent;
  const std::size_t ball = recent.add(channel("/ball"));
  write(recent, ball, {10 * kSecond, 9'500 * kMillisecond, 11 * kSecond});
  EXPECT_EQ(messages_of(recent)["/ball"].size(), 3u);
}

TEST(RecentFile, AChannelMayComeLater) {
  RecentFile recent({.chunk_ns = kSecond});
  write(recent, recent.add(channel("/ball")), every(kSecond / 10, 0, 5 * kSecond));
  write(recent, recent.add(channel("/pose")), every(kSecond / 10, 3 * kSecond, 5 * kSecond));
  Messages messages = messages_of(recent);
  EXPECT_EQ(messages["/ball"].size(), 51u);
  EXPECT_EQ(messages["/pose"].size(), 21u);
}

TEST(RecentFile, ManyChunksReplaceTheWriterWithoutALoss) {
  RecentFile recent({.chunk_bytes = 1});  // each message is a chunk
  const std::size_t ball = recent.add(channel("/ball")), pose = recent.add(channel("/pose"));
  for (std::uint64_t i = 1; i <= 1700; ++i)
    for (const std::size_t one : {ball, pose}) ASSERT_TRUE(recent.write(one, {i, i * kMillisecond, i, "x"}));
  Messages messages = messages_of(recent);
  EXPECT_EQ(times_of(messages["/ball"]), every(kMillisecond, kMillisecond, 1700 * kMillisecond));
  EXPECT_EQ(times_of(messages["/pose"]), every(kMillisecond, kMillisecond, 1700 * kMillisecond));
}

TEST(RecentFile, AFileThatWasHandedOutDoesNotChange) {
  RecentFile recent;
  const std::size_t ball = recent.add(channel("/ball"));
  write(recent, ball, every(kSecond / 10, 0, 5 * kSecond));
  const auto before = *recent.file();
  const std::string bytes = *read_bytes(*before, 0, before->size());
  write(recent, ball, every(kSecond / 10, 6 * kSecond, 900 * kSecond));
  (void)recent.file();
  EXPECT_EQ(*read_bytes(*before, 0, before->size()), bytes);
}

}  // namespace
}  // namespace robot::logging
