// McapWriter with many channels in one file.
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <vector>

#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/reader.h"
#include "robot/logging/mcap/writer.h"
#include "tests/support/mcap_text.h"

namespace robot::logging {
namespace {

using namespace tests;

constexpr std::uint16_t kFirstId = 7;
constexpr std::size_t kA = 0, kB = 1, kC = 2;  // of the three channels

std::vector<memory::ChannelInfo> three_channels() {
  return {word_channel("/a"), word_channel("/b"), word_channel("/c")};
}

McapWriter three_to(Disk& disk, McapOptions options = {}) {
  options.first_channel_id = kFirstId;
  auto writer = McapWriter::open(std::make_unique<DiskSink>(disk), three_channels(), options);
  EXPECT_TRUE(writer) << writer.error();
  return std::move(*writer);
}

/// Returns the messages of a file by topic, in the order of the file. The test fails if one is damaged.
std::map<std::string, std::vector<Record>> records_of(const std::string& bytes) {
  McapReader reader(std::make_shared<MemorySource>(bytes));
  std::map<std::string, std::vector<Record>> records;
  while (true) {
    auto message = reader.next();
    if (!message) ADD_FAILURE() << message.error();
    if (!message || !*message) return records;
    records[reader.channels().at((*message)->channel_id).topic].push_back(std::move((*message)->record));
  }
}

/// Writes 300 messages to random channels of the three but not to /c, and returns them by topic.
std::map<std::string, std::vector<Record>> write_mixed(McapWriter& writer) {
  std::mt19937 random(1);
  std::map<std::string, std::vector<Record>> written;
  for (std::uint64_t i = 1; i <= 300; ++i) {
    const std::size_t channel = random() % 3 == 0 ? kA : kB;
    std::vector<Record>& records = written[three_channels()[channel].topic];
    std::string bytes(random() % 10 == 0 ? random() % 10'000 : random() % 50, static_cast<char>(random()));
    records.push_back({records.size() + 1, 1000 * i + random() % 3000, 1000 * i, std::move(bytes)});
    const Record& record = records.back();
    EXPECT_TRUE(writer.write(channel, {record.sequence, record.capture_ns, record.publish_ns, record.bytes}, i));
  }
  return written;
}

std::vector<McapOptions> options_of_every_kind() {
  std::vector<McapOptions> every;
  for (const auto compression : {Compression::none, Compression::lz4, Compression::zstd})
    for (const std::size_t chunk_bytes : {1u, 100u, 5000u, 1u << 20})
      every.push_back({.compression = compression, .chunk_bytes = chunk_bytes, .chunk_time_ns = 20});
  return every;
}

TEST(McapWriterChannels, ReadingReturnsTheMessagesOfEachChannel) {
  for (const McapOptions& options : options_of_every_kind()) {
    Disk disk;
    McapWriter writer = three_to(disk, options);
    const auto written = write_mixed(writer);
    ASSERT_TRUE(writer.close());
    EXPECT_EQ(records_of(disk.bytes), written);
    EXPECT_EQ(writer.messages(), 300u);
    EXPECT_EQ(writer.size_bytes(), disk.bytes.size());
  }
}

TEST(McapWriterChannels, AChunkHoldsTheMessagesOfOneChannel) {
  for (const McapOptions& options : options_of_every_kind()) {
    Disk disk;
    McapWriter writer = three_to(disk, options);
    (void)write_mixed(writer);
    ASSERT_TRUE(writer.close());
    const auto index = read_index(MemorySource(disk.bytes));
    ASSERT_TRUE(index) << index.error();
    for (const ChunkInfo& chunk : index->chunks) EXPECT_EQ(chunk.messages.size(), 1u);
  }
}

TEST(McapWriterChannels, TheSameCallsGiveTheSameBytes) {
  for (const McapOptions& options : options_of_every_kind()) {
    Disk first, second;
    for (Disk* disk : {&first, &second}) {
      McapWriter writer = three_to(*disk, options);
      (void)write_mixed(writer);
      ASSERT_TRUE(writer.close());
    }
    EXPECT_EQ(first.bytes, second.bytes);
  }
}

TEST(McapWriterChannels, StatisticsNameOnlyChannelsWithMessages) {
  Disk disk;
  McapWriter writer = three_to(disk);
  const auto written = write_mixed(writer);
  ASSERT_TRUE(writer.close());
  const mcap::Statistics statistics = read_index(MemorySource(disk.bytes))->statistics;
  const mcap::Numbers<std::uint16_t> expected = {{kFirstId, written.at("/a").size()},
                                                 {kFirstId + 1, written.at("/b").size()}};
  EXPECT_EQ(statistics.channel_messages, expected);
  EXPECT_EQ(statistics.channels, 3u);
}

TEST(McapWriterChannels, EqualSchemasAreWrittenOnce) {
  std::vector<memory::ChannelInfo> channels = three_channels();
  channels[kB].schema.bytes = "another text of the same name";
  channels[kC].delivery = memory::Delivery::latest;
  for (const bool finished : {true, false}) {
    Disk disk;
    auto writer = McapWriter::open(std::make_unique<DiskSink>(disk), channels, {.first_channel_id = kFirstId});
    ASSERT_TRUE(writer) << writer.error();
    ASSERT_TRUE(!finished || writer->close());
    const auto index = read_index(MemorySource(disk.bytes));
    ASSERT_TRUE(index) << index.error();
    EXPECT_EQ(index->schemas.size(), 2u);
    EXPECT_EQ(index->statistics.schemas, 2u);
    ASSERT_EQ(index->channels.size(), 3u);
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const auto id = static_cast<std::uint16_t>(kFirstId + i);
      EXPECT_EQ(channel_info(index->channels.at(id), index->schemas), channels[i]);
    }
  }
}

TEST(McapWriterChannels, EachChannelHasItsOwnTimeOfTheNextFlush) {
  Disk disk;
  McapWriter writer = three_to(disk);
  ASSERT_TRUE(writer.write(kB, word("b", 1), 5 * kSecond));
  ASSERT_TRUE(writer.write(kA, word("a", 2), 5 * kSecond + 300));
  EXPECT_EQ(writer.flush_due_ns(), 6 * kSecond);
  ASSERT_TRUE(writer.flush(6 * kSecond - 1));
  EXPECT_EQ(writer.messages(), 0u);

  // only /b is due, also when another channel gets a message
  ASSERT_TRUE(writer.write(kC, word("c", 3), 6 * kSecond));
  EXPECT_EQ(writer.messages(), 0u);
  ASSERT_TRUE(writer.flush(6 * kSecond));
  EXPECT_EQ(words_of(std::make_shared<MemorySource>(disk.bytes)), "b !");
  EXPECT_EQ(writer.flush_due_ns(), 6 * kSecond + 300);
  ASSERT_TRUE(writer.flush());
  EXPECT_EQ(words_of(std::make_shared<MemorySource>(disk.bytes)), "b a c !");
  EXPECT_EQ(writer.flush_due_ns(), McapWriter::kNever);
}

TEST(McapWriterChannels, AFullChunkIsWrittenWithoutTheOthers) {
  Disk disk;
  McapWriter writer = three_to(disk, {.chunk_bytes = 1000});
  ASSERT_TRUE(writer.write(kA, word(std::string(900, 'a'), 1), 0));
  ASSERT_TRUE(writer.write(kB, word(std::string(900, 'b'), 2), 0));
  EXPECT_EQ(writer.messages(), 0u);
  ASSERT_TRUE(writer.write(kB, word(std::string(100, 'b'), 3), 0));
  EXPECT_EQ(writer.messages(), 2u);
  ASSERT_TRUE(writer.close());
  EXPECT_EQ(records_of(disk.bytes)["/a"].size(), 1u);
}

/// Fills the chunk of /a on a disk with `room` more bytes while /b and /c have messages, too. Then the disk has room.
void fail_in_the_middle(std::uint64_t room, bool can_truncate) {
  Disk disk;
  McapWriter writer = three_to(disk, {.chunk_bytes = 300});
  ASSERT_TRUE(writer.write(kB, word("b1", 1), 0));
  ASSERT_TRUE(writer.write(kA, word("a1", 2), 0));
  ASSERT_TRUE(writer.write(kC, word("c1", 3), 0));
  disk.room = disk.bytes.size() + room;
  disk.can_truncate = can_truncate;
  const Result<void> filled = writer.write(kA, word(std::string(300, 'a'), 4), 0);
  EXPECT_EQ(writer.lost(), filled ? 0u : 2u);
  EXPECT_EQ(filled ? "" : filled.error(), filled ? "" : "cannot write disk: no room; messages lost: 2");

  disk = {disk.bytes};
  ASSERT_TRUE(writer.write(kB, word("b2", 5), 0));
  ASSERT_TRUE(writer.write(kA, word("a3", 6), 0));
  ASSERT_TRUE(writer.close());
  auto records = records_of(disk.bytes);
  EXPECT_EQ(records["/a"].size(), filled ? 3u : 1u);
  EXPECT_EQ(records["/a"].back().bytes, "a3");
  EXPECT_EQ(records["/b"].size(), 2u);
  EXPECT_EQ(records["/c"].size(), 1u);
}

TEST(McapWriterChannels, AFailureCostsOnlyTheMessagesOfItsChunk) {
  for (std::uint64_t room = 0; room < 700; ++room) {
    fail_in_the_middle(room, true);
    fail_in_the_middle(room, false);  // truncation fails too, for a while
  }
}

TEST(McapWriterChannels, AnErrorOfFlushContainsTheLostMessagesOfAllChannels) {
  for (std::uint64_t room = 0; room < 700; ++room) {
    Disk disk;
    McapWriter writer = three_to(disk);
    ASSERT_TRUE(writer.write(kA, word("a", 1), 0));
    ASSERT_TRUE(writer.write(kA, word(std::string(200, 'a'), 2), 0));
    ASSERT_TRUE(writer.write(kB, word("b", 3), 0));
    ASSERT_TRUE(writer.write(kC, word("c", 4), 0));
    disk.room = disk.bytes.size() + room;
    const Result<void> flushed = writer.flush();
    EXPECT_EQ(bool(flushed), writer.lost() == 0);
    const std::string loss = "; messages lost: " + std::to_string(writer.lost());
    EXPECT_TRUE(flushed || flushed.error().ends_with(loss)) << flushed.error();
    EXPECT_EQ(writer.messages() + writer.lost(), 4u);
    EXPECT_EQ(writer.flush_due_ns(), McapWriter::kNever);
    EXPECT_EQ(writer.size_bytes(), disk.bytes.size());
  }
}

TEST(McapWriterChannels, CloseMayBeCalledAgainAfterAnError) {
  for (std::uint64_t room = 0; room < 1500; room += 7) {
    Disk disk;
    McapWriter writer = three_to(disk);
    ASSERT_TRUE(writer.write(kA, word("a", 1), 0));
    ASSERT_TRUE(writer.write(kC, word("c", 2), 0));
    disk.room = disk.bytes.size() + room;
    const bool closed = bool(writer.close());
    EXPECT_TRUE(closed || disk.bytes.size() == writer.size_bytes());
    disk.room = std::numeric_limits<std::uint64_t>::max();
    ASSERT_TRUE(writer.close());
    const auto index = read_index(MemorySource(disk.bytes));
    ASSERT_TRUE(index) << index.error();
    EXPECT_TRUE(index->complete);
    EXPECT_EQ(index->statistics.messages, writer.messages());
    EXPECT_EQ(writer.messages() + writer.lost(), 2u);
    std::size_t read = 0;
    for (const auto& [topic, records] : records_of(disk.bytes)) read += records.size();
    EXPECT_EQ(read, writer.messages());
  }
}

}  // namespace
}  // namespace robot::logging
