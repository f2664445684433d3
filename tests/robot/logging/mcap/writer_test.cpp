#include "robot/logging/mcap/writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/reader.h"
#include "tests/support/mcap_text.h"

namespace robot::logging {
namespace {

using namespace std::string_literals;
using namespace tests;

std::uint32_t crc(std::string_view bytes) { return mcap::crc32(bytes); }

/// A writer of little-endian numbers and strings that shares no code with ours.
struct Hand {
  std::string bytes;
  Hand& u8(unsigned value) { return number(value, 1); }
  Hand& u16(std::uint64_t value) { return number(value, 2); }
  Hand& u32(std::uint64_t value) { return number(value, 4); }
  Hand& u64(std::uint64_t value) { return number(value, 8); }
  Hand& text(std::string_view value) {
    u32(value.size());
    bytes += value;
    return *this;
  }
  Hand& number(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<char>(value >> (8 * i)));
    return *this;
  }
  Hand& record(unsigned op, const Hand& content) {
    u8(op).u64(content.bytes.size());
    bytes += content.bytes;
    return *this;
  }
};

// every byte is written by hand from the specification
TEST(McapWriter, ASmallFileHasTheBytesOfTheSpecification) {
  Disk disk;
  McapOptions options;
  options.first_channel_id = 7;
  options.library = "lib";
  options.metadata = {{"session", {{"team", "14"}}}};
  McapWriter writer = writer_to(disk, options);
  ASSERT_TRUE(writer.write(0, {5, 100, 101, "hi"}, 0));
  ASSERT_TRUE(writer.close());

  Hand file;
  file.bytes = "\x89MCAP0\r\n"s;
  file.record(0x01, Hand().text("").text("lib"));
  const std::size_t metadata_offset = file.bytes.size();
  file.record(0x0c, Hand().text("session").u32(4 + 4 + 4 + 2).text("team").text("14"));
  const std::size_t metadata_bytes = file.bytes.size() - metadata_offset;
  const Hand schema = Hand().u16(1).text("foresight.Word").text("protobuf").text("schema of a word");
  const Hand channel =
      Hand().u16(7).u16(1).text("/14/2/word").text("protobuf").u32(4 + 8 + 4 + 8).text("delivery").text("reliable");
  file.record(0x03, schema).record(0x04, channel);

  Hand message = Hand().u16(7).u32(5).u64(100).u64(101);
  message.bytes += "hi";
  const Hand records = Hand().record(0x05, message);
  Hand chunk = Hand().u64(100).u64(100).u64(records.bytes.size()).u32(crc(records.bytes)).text("");
  chunk.u64(records.bytes.size()).bytes += records.bytes;
  const std::size_t chunk_offset = file.bytes.size();
  file.record(0x06, chunk);
  const std::size_t index_offset = file.bytes.size();
  file.record(0x07, Hand().u16(7).u32(16).u64(100).u64(0));
  const std::size_t index_bytes = file.bytes.size() - index_offset;

  file.record(0x0f, Hand().u32(crc(file.bytes)));
  const std::size_t summary_start = file.bytes.size();
  file.record(0x03, schema);
  const std::size_t channels = file.bytes.size();
  file.record(0x04, channel);
  const std::size_t statistics = file.bytes.size();
  file.record(0x0b, Hand().u64(1).u16(1).u32(1).u32(0).u32(1).u32(1).u64(100).u64(100).u32(10).u16(7).u64(1));
  const std::size_t metadata_index = file.bytes.size();
  file.record(0x0d, Hand().u64(metadata_offset).u64(metadata_bytes).text("session"));
  const std::size_t chunk_index = file.bytes.size();
  file.record(0x08, Hand()
                        .u64(100)
                        .u64(100)
                        .u64(chunk_offset)
                        .u64(index_offset - chunk_offset)
                        .u32(10)
                        .u16(7)
                        .u64(index_offset)
                        .u64(index_bytes)
                        .text("")
                        .u64(records.bytes.size())
                        .u64(records.bytes.size()));
  const std::size_t offsets = file.bytes.size();
  file.record(0x0e, Hand().u8(0x03).u64(summary_start).u64(channels - summary_start));
  file.record(0x0e, Hand().u8(0x04).u64(channels).u64(statistics - channels));
  file.record(0x0e, Hand().u8(0x0b).u64(statistics).u64(metadata_index - statistics));
  file.record(0x0e, Hand().u8(0x0d).u64(metadata_index).u64(chunk_index - metadata_index));
  file.record(0x0e, Hand().u8(0x08).u64(chunk_index).u64(offsets - chunk_index));
  file.u8(0x02).u64(20).u64(summary_start).u64(offsets);
  file.u32(crc(std::string_view(file.bytes).substr(summary_start))).bytes += "\x89MCAP0\r\n"s;
  EXPECT_EQ(disk.bytes, file.bytes);
}

TEST(McapWriter, ReadingReturnsTheWrittenMessages) {
  std::mt19937 random(1);
  for (const auto compression : {Compression::none, Compression::lz4, Compression::zstd})
    for (const std::size_t chunk_bytes : {1u, 100u, 5000u, 1u << 20}) {
      McapOptions options;
      options.compression = compression;
      options.chunk_bytes = chunk_bytes;
      Disk disk;
      McapWriter writer = writer_to(disk, options);
      std::vector<Record> written;
      for (std::uint64_t i = 1; i <= 200; ++i) {
        std::string bytes(random() % 10 == 0 ? random() % 10'000 : random() % 50, static_cast<char>(random()));
        if (random() % 2) std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random()); });
        written.push_back({i, 1000 * i + random() % 3000, 1000 * i, std::move(bytes)});
        const Record& record = written.back();
        ASSERT_TRUE(writer.write(0, {record.sequence, record.capture_ns, record.publish_ns, record.bytes}, i));
      }
      ASSERT_TRUE(writer.close());
      EXPECT_EQ(writer.messages(), 200u);
      EXPECT_EQ(writer.size_bytes(), disk.bytes.size());

      McapReader reader(std::make_shared<MemorySource>(disk.bytes));
      for (const Record& record : written) {
        const auto read = reader.next();
        ASSERT_TRUE(read) << read.error();
        ASSERT_TRUE(*read);
        EXPECT_EQ((*read)->record, record);
      }
      const auto end = reader.next();
      ASSERT_TRUE(end) << end.error();
      EXPECT_FALSE(*end);
    }
}

TEST(McapWriter, WithoutMessagesTheFileIsValid) {
  Disk disk;
  McapWriter writer = writer_to(disk);
  ASSERT_TRUE(writer.close());
  const auto index = read_index(MemorySource(disk.bytes));
  ASSERT_TRUE(index) << index.error();
  EXPECT_TRUE(index->complete);
  EXPECT_EQ(index->damage, "");
  EXPECT_EQ(channel_info(index->channels.at(1), index->schemas), word_channel());
}

TEST(McapWriter, AChunkIsWrittenWhenItIsFull) {
  McapOptions options;
  options.chunk_bytes = 1000;
  Disk disk;
  McapWriter writer = writer_to(disk, options);
  const std::size_t head_bytes = disk.bytes.size();
  ASSERT_TRUE(writer.write(0, word(std::string(900, 'x'), 1), 0));
  EXPECT_EQ(disk.bytes.size(), head_bytes);
  ASSERT_TRUE(writer.write(0, word(std::string(100, 'y'), 2), 0));
  EXPECT_EQ(words_of(std::make_shared<MemorySource>(disk.bytes)),
            std::string(900, 'x') + " " + std::string(100, 'y') + " !");
}

TEST(McapWriter, AChunkIsWrittenWhenItsFirstMessageIsOld) {
  Disk disk;
  McapWriter writer = writer_to(disk);
  EXPECT_EQ(writer.flush_due_ns(), McapWriter::kNever);
  ASSERT_TRUE(writer.write(0, word("a", 1), 5 * kSecond));
  EXPECT_EQ(writer.flush_due_ns(), 6 * kSecond);
  ASSERT_TRUE(writer.write(0, word("b", 2), 6 * kSecond - 1));
  EXPECT_EQ(writer.messages(), 0u);
  ASSERT_TRUE(writer.write(0, word("c", 3), 6 * kSecond));
  EXPECT_EQ(writer.messages(), 3u);
  EXPECT_EQ(writer.flush_due_ns(), McapWriter::kNever);
}

TEST(McapWriter, FlushWritesTheCollectedMessages) {
  Disk disk;
  McapWriter writer = writer_to(disk);
  ASSERT_TRUE(writer.flush());
  ASSERT_TRUE(writer.write(0, word("a", 1), 0));
  ASSERT_TRUE(writer.flush());
  EXPECT_EQ(words_of(std::make_shared<MemorySource>(disk.bytes)), "a !");  // the file has no end yet
}

TEST(McapWriter, AChunkThatDoesNotGetSmallerIsNotCompressed) {
  McapOptions options;
  options.compression = Compression::lz4;
  const McapText small("a", options);
  EXPECT_EQ(read_index(*small.source())->chunks[0].index.compression, "");
}

TEST(McapWriter, RefusesAMessageThatIsTooLargeForReaders) {
  Disk disk;
  McapWriter writer = writer_to(disk);
  const std::string huge(mcap::kMaxRecordBytes / 2 + 1, 'x');
  EXPECT_FALSE(writer.write(0, word(huge, 1), 0));
  EXPECT_EQ(writer.lost(), 1u);
  ASSERT_TRUE(writer.write(0, word("a", 1), 0));
  ASSERT_TRUE(writer.close());
  EXPECT_EQ(words_of(std::make_shared<MemorySource>(disk.bytes)), "a");
}

TEST(McapWriter, OpeningOnAFullDiskIsAnError) {
  const std::size_t head_bytes = [] {
    Disk disk;
    writer_to(disk);
    return disk.bytes.size();
  }();
  for (std::size_t room = 0; room < head_bytes; ++room) {
    Disk disk;
    disk.room = room;
    const memory::ChannelInfo channel = word_channel();
    const auto writer = McapWriter::open(std::make_unique<DiskSink>(disk), {&channel, 1}, {});
    ASSERT_FALSE(writer);
    EXPECT_EQ(writer.error(), "cannot write disk: no room");
    EXPECT_EQ(disk.bytes, "");
  }
}

/// Writes "a b", "c d", "e f" as three chunks on a disk that is full at `room` bytes until the message `e`.
void write_on_full_disk(std::uint64_t room, bool can_truncate, Compression compression) {
  Disk disk;
  McapOptions options;
  options.compression = compression;
  McapWriter writer = writer_to(disk, options);
  disk.room = disk.bytes.size() + room;
  disk.can_truncate = can_truncate;
  std::string expected;
  std::uint64_t lost = 0;
  for (const std::string first : {"a", "c", "e"}) {
    if (first == "e") disk = {disk.bytes};
    const std::string second(1, static_cast<char>(first[0] + 1));
    ASSERT_TRUE(writer.write(0, word(first, 1), 0));
    ASSERT_TRUE(writer.write(0, word(second, 2), 0));
    const Result<void> flushed = writer.flush();
    if (flushed) expected.append(expected.empty() ? "" : " ").append(first).append(" ").append(second);
    if (!flushed) {
      lost += 2;
      EXPECT_TRUE(flushed.error().ends_with("; messages lost: 2")) << flushed.error();
    }
    EXPECT_TRUE(disk.bytes.size() == writer.size_bytes() || !can_truncate);
  }
  EXPECT_EQ(writer.lost(), lost);
  ASSERT_TRUE(writer.close());
  EXPECT_TRUE(expected.ends_with("e f"));
  EXPECT_EQ(words_of(std::make_shared<MemorySource>(disk.bytes)), expected) << room;
}

TEST(McapWriter, ContinuesWhenAFullDiskHasRoomAgain) {
  for (std::uint64_t room = 0; room < 400; ++room) {
    write_on_full_disk(room, true, Compression::none);
    write_on_full_disk(room, false, Compression::none);  // truncation fails too, for a while
    write_on_full_disk(room, true, Compression::zstd);
  }
}

TEST(McapWriter, CloseMayBeCalledAgainAfterAnError) {
  for (std::uint64_t room = 0; room < 400; room += 7) {
    Disk disk;
    McapWriter writer = writer_to(disk);
    ASSERT_TRUE(writer.write(0, word("a", 1), 0));
    ASSERT_TRUE(writer.flush());
    disk.room = disk.bytes.size() + room;
    const bool closed = bool(writer.close());
    EXPECT_EQ(words_of(std::make_shared<MemorySource>(disk.bytes)), closed ? "a" : "a !");
    disk.room = std::numeric_limits<std::uint64_t>::max();
    ASSERT_TRUE(writer.close());
    EXPECT_EQ(words_of(std::make_shared<MemorySource>(disk.bytes)), "a");
  }
}

}  // namespace
}  // namespace robot::logging
