#include "robot/logging/mcap/index.h"

#include <gtest/gtest.h>

#include "robot/logging/mcap/reader.h"
#include "tests/support/mcap_text.h"

namespace robot::logging {
namespace {

using tests::McapText;

const McapOptions kOptions{.first_channel_id = 7, .metadata = {{"session", {{"team", "14"}}}}};

/// Returns all facts of an index about chunks, as text.
std::string told(const McapIndex& index) {
  std::string text;
  for (const ChunkInfo& chunk : index.chunks) {
    const mcap::ChunkIndex& place = chunk.index;
    text += std::to_string(place.offset) + "+" + std::to_string(place.record_bytes) + "+" +
            std::to_string(place.message_index_bytes) + " " + std::to_string(place.start_ns) + ".." +
            std::to_string(place.end_ns) + " " + place.compression + std::to_string(place.packed_bytes) + "/" +
            std::to_string(place.unpacked_bytes);
    for (const auto& [channel, count] : chunk.messages)
      text += " " + std::to_string(channel) + "*" + std::to_string(count);
    for (const auto& [channel, offset] : place.message_indexes) text += " @" + std::to_string(offset);
    text += "\n";
  }
  const mcap::Statistics& statistics = index.statistics;
  return text + std::to_string(statistics.messages) + " " + std::to_string(statistics.start_ns) + ".." +
         std::to_string(statistics.end_ns) + " " + std::to_string(statistics.chunks) + " " +
         std::to_string(statistics.channels) + " " + std::to_string(statistics.schemas) + " " +
         std::to_string(statistics.metadata);
}

TEST(McapIndex, ListsTheContentsOfTheFileAndTheirPlaces) {
  const McapText text("one two | three", kOptions);
  const auto index = read_index(*text.source());
  ASSERT_TRUE(index) << index.error();
  EXPECT_TRUE(index->complete);
  EXPECT_EQ(index->damage, "");
  EXPECT_EQ(index->header.library, "foresight");
  EXPECT_EQ(index->size_bytes, text.bytes.size());
  EXPECT_EQ(index->metadata.at(0).entries.at("team"), "14");
  EXPECT_EQ(channel_info(index->channels.at(7), index->schemas), tests::word_channel());
  ASSERT_EQ(index->chunks.size(), 2u);
  EXPECT_EQ(index->chunks[0].index.offset, text.chunks()[0]);
  EXPECT_EQ(index->chunks[0].index.end_ns, 20u);
  EXPECT_EQ(index->chunks[0].messages, (mcap::Numbers<std::uint16_t>{{7, 2}}));
  EXPECT_EQ(index->chunks[1].index.start_ns, 30u);
  EXPECT_EQ(index->statistics.messages, 3u);
}

TEST(McapIndex, AScanGivesTheSameIndexAsTheSummary) {
  const McapText finished("one two | three | four five six", kOptions);
  const McapText interrupted("one two | three | four five six", kOptions, /*finished=*/false);
  const auto index = read_index(*finished.source()), scanned = read_index(*interrupted.source());
  EXPECT_EQ(told(*scanned), told(*index));
  EXPECT_FALSE(scanned->complete);
  EXPECT_EQ(scanned->damage, "memory: ends at byte " + std::to_string(interrupted.bytes.size()) +
                                 " without a DataEnd: its writer was interrupted");
}

TEST(McapIndex, HasEveryCompleteChunkOfEveryTruncation) {
  const McapText text("one two | three | four", kOptions);
  const std::size_t head_bytes = text.chunks()[0];
  const auto whole = read_index(*text.source());
  for (std::size_t size = 0; size < text.bytes.size(); ++size) {
    McapText cut = text;
    cut.truncate(size);
    const auto index = read_index(*cut.source());
    if (size < 8 + 26) {
      EXPECT_FALSE(index) << size;  // not even a header
      continue;
    }
    ASSERT_TRUE(index) << size << index.error();
    EXPECT_FALSE(index->complete);
    EXPECT_NE(index->damage, "");
    EXPECT_EQ(index->channels.size(), size >= head_bytes) << size;
    std::size_t complete = 0;
    for (const ChunkInfo& chunk : whole->chunks) complete += chunk.index.offset + chunk.index.record_bytes <= size;
    EXPECT_EQ(index->chunks.size(), complete) << size;
  }
}

TEST(McapIndex, SurvivesEveryBrokenByte) {
  const McapText text("one two | three | four", kOptions);
  const auto whole = read_index(*text.source());
  const std::string told_whole = told(*whole);
  const mcap::ChunkIndex& last = whole->chunks.back().index;
  const std::uint64_t data_end = last.offset + last.record_bytes + last.message_index_bytes + 9 + 4;
  for (const int delta : {1, 0x80, 0xff})
    for (std::size_t i = 0; i < text.bytes.size(); ++i) {
      McapText broken = text;
      broken.increment_byte(i, delta);
      const auto index = read_index(*broken.source());
      if (i < data_end) continue;
      // a broken summary is rebuilt from the data, which are undamaged
      ASSERT_TRUE(index) << i << index.error();
      EXPECT_EQ(told(*index), told_whole) << i;
      EXPECT_NE(index->damage, "") << i;
    }
}

TEST(McapIndex, RefusesAFileThatIsNotMcap) {
  EXPECT_EQ(read_index(MemorySource("", "a.mcap")).error(),
            "a.mcap: not an MCAP file: expected the magic bytes at its start");
  EXPECT_FALSE(read_index(MemorySource("{\"some\": \"JSON\"}")));
}

TEST(McapIndex, LeavesOutTheLastChunkOfAnInterruptedFileIfItIsDamaged) {
  McapText text("one two | three", kOptions, /*finished=*/false);
  text.increment_byte(text.chunks()[1] + 9 + 40 + 31);  // in the word "three"
  const auto index = read_index(*text.source());
  ASSERT_TRUE(index) << index.error();
  EXPECT_EQ(index->chunks.size(), 1u);
  EXPECT_EQ(index->statistics.messages, 2u);
}

/// A file of another writer: two channels described inside the chunk, no message indexes, one message outside chunks.
std::string foreign_file(bool loose) {
  using namespace mcap;
  std::string records;
  append(records, Schema{1, "s", "protobuf", "d"});
  append(records, Channel{1, 1, "/a", "protobuf", {}});
  append(records, Channel{2, 0, "/b", "json", {}});
  append(records, Message{1, 1, 10, 10, "one"});
  append(records, Message{2, 1, 20, 20, "two"});
  std::string file(kMagic);
  append(file, Header{"", "other"});
  append(file, ChunkHead{10, 20, records.size(), 0, "", records.size()}, records.size());
  file += records;
  if (loose) append(file, Message{1, 2, 30, 30, "three"});
  append(file, DataEnd{});
  append(file, Footer{});
  return file.append(kMagic);
}

TEST(McapIndex, CompletesFactsThatOtherWritersLeaveOut) {
  const auto index = read_index(MemorySource(foreign_file(true)));
  ASSERT_TRUE(index) << index.error();
  EXPECT_TRUE(index->complete);
  EXPECT_EQ(index->damage, "");
  EXPECT_EQ(index->channels.at(2).topic, "/b");
  EXPECT_EQ(index->unchunked_messages, 1u);
  EXPECT_EQ(index->statistics.messages, 3u);
  EXPECT_EQ(index->chunks.at(0).messages, (mcap::Numbers<std::uint16_t>{{1, 1}, {2, 1}}));
  EXPECT_EQ(tests::words_of(std::make_shared<MemorySource>(foreign_file(true))), "one two three");
}

}  // namespace
}  // namespace robot::logging
