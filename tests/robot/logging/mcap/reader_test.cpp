#include "robot/logging/mcap/reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/support/mcap_text.h"

namespace robot::logging {
namespace {

using tests::McapText;
using tests::words_of;

constexpr Compression kAll[] = {Compression::none, Compression::lz4, Compression::zstd};

// words that are long enough to be compressed
const std::string kText =
    "one-one-one-one-one-one-one-one-one-one-one-one-one two | "
    "three-three-three-three-three-three-three-three-three-three-three-three | four five five-five-five-five-five-five";

std::vector<std::string> split(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    if (word != "|") words.push_back(word);
  return words;
}

/// Returns the number of messages in chunks that end at `size` or before.
std::size_t messages_before(const McapIndex& index, std::uint64_t size) {
  std::size_t count = 0;
  for (const ChunkInfo& chunk : index.chunks)
    if (chunk.index.offset + chunk.index.record_bytes <= size) count += chunk.messages[0].second;
  return count;
}

TEST(McapReader, DeliversTheMessagesInTheOrderOfTheFile) {
  std::vector<std::string> damages;
  EXPECT_EQ(words_of(McapText("one two | three").source(), &damages), "one two three");
  EXPECT_TRUE(damages.empty());
}

TEST(McapReader, KnowsEachMessagesChannel) {
  McapReader reader(McapText("one", {.first_channel_id = 7}).source());
  const auto message = reader.next();
  ASSERT_TRUE(message && *message);
  EXPECT_EQ((*message)->channel_id, 7);
  EXPECT_EQ((*message)->record, (Record{10, 10, 11, "one"}));
  EXPECT_EQ(channel_info(reader.channels().at(7), reader.schemas()), tests::word_channel());
}

TEST(McapReader, DeliversEverythingBeforeEveryTruncation) {
  for (const Compression compression : kAll) {
    const McapText text(kText, {.compression = compression});
    const auto index = read_index(*text.source());
    const auto expected = split(kText);
    for (std::size_t size = 0; size < text.bytes.size(); ++size) {
      McapText cut = text;
      cut.truncate(size);
      std::vector<std::string> damages;
      auto words = split(words_of(cut.source(), &damages));
      ASSERT_EQ(damages.size(), 1u) << size;
      EXPECT_EQ(words.back(), "!");
      words.pop_back();
      ASSERT_EQ(words.size(), messages_before(*index, size)) << size;
      EXPECT_TRUE(std::equal(words.begin(), words.end(), expected.begin())) << size;
    }
  }
}

TEST(McapReader, DeliversEverythingBeforeEveryBrokenByteAndReportsIt) {
  for (const Compression compression : kAll)
    for (const int delta : {1, 0x80, 0xff}) {
      const McapText text(kText, {.compression = compression});
      const auto index = read_index(*text.source());
      const auto expected = split(kText);
      for (std::size_t i = 0; i < text.bytes.size(); ++i) {
        McapText broken = text;
        broken.increment_byte(i, delta);
        std::vector<std::string> damages;
        const auto words = split(words_of(broken.source(), &damages));
        EXPECT_FALSE(damages.empty()) << i;
        std::vector<std::string> sorted = damages;
        std::sort(sorted.begin(), sorted.end());
        const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
        EXPECT_TRUE(twice == sorted.end()) << i << ": told twice: " << *twice;
        const std::size_t before = messages_before(*index, i);
        ASSERT_GE(words.size(), before) << i;
        EXPECT_TRUE(std::equal(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(before), words.begin()))
            << i;
      }
    }
}

TEST(McapReader, LeavesOutADamagedChunkAndContinues) {
  McapText text("one two | three | four");
  text.increment_byte(text.chunks()[1] + 9 + 40 + 31);  // in the word "three"
  std::vector<std::string> damages;
  EXPECT_EQ(words_of(text.source(), &damages), "one two ! four");
  EXPECT_EQ(damages[0],
            "memory: Chunk at byte " + std::to_string(text.chunks()[1]) + ": its checksum is wrong, it is damaged");
}

TEST(McapReader, ContinuesWithTheSummaryWhenSizesAreInvalid) {
  for (int byte = 1; byte <= 8; ++byte) {
    McapText text("one two | three | four");
    text.increment_byte(text.chunks()[1] + static_cast<unsigned>(byte), 0x40);  // in the length of the chunk
    EXPECT_TRUE(words_of(text.source()).ends_with("four")) << byte << ": " << words_of(text.source());
    EXPECT_TRUE(words_of(text.source()).starts_with("one two ")) << byte;
  }
}

TEST(McapReader, TheSummaryDescribesAChannelWhoseOwnRecordIsDamaged) {
  McapText text("one two | three");
  text.increment_byte(text.bytes.find("/14/2/word") - 4);  // the length of the topic
  text.increment_byte(text.bytes.find("/14/2/word") - 3);
  std::vector<std::string> damages;
  EXPECT_EQ(words_of(text.source(), &damages), "! one two three");
}

TEST(McapReader, TheChecksumOverAllDataFindsADamageThatNoOtherFinds) {
  McapText text("one two | three");
  text.increment_byte(text.chunks()[0] + 9 + 40 + 31);
  text.fix_chunk_crcs();
  std::vector<std::string> damages;
  EXPECT_EQ(words_of(text.source(), &damages), "pne two three !");
  EXPECT_NE(damages[0].find("the data before byte"), std::string::npos) << damages[0];
}

TEST(McapReader, RefusesAFileThatIsNotMcap) {
  for (const std::string bytes : {"", "x", "{\"some\": \"JSON\"}"}) {
    std::vector<std::string> damages;
    EXPECT_EQ(words_of(std::make_shared<MemorySource>(bytes), &damages), "!");
    EXPECT_EQ(damages[0], "memory: not an MCAP file: expected the magic bytes at its start");
  }
}

TEST(McapReader, ReportsAnUnknownChannelOnce) {
  std::string bytes(mcap::kMagic);
  mcap::append(bytes, mcap::Header{});
  mcap::append(bytes, mcap::Message{3, 1, 1, 1, "x"});
  mcap::append(bytes, mcap::Message{3, 2, 2, 2, "y"});
  mcap::append(bytes, mcap::DataEnd{});
  mcap::append(bytes, mcap::Footer{});
  bytes += mcap::kMagic;
  std::vector<std::string> damages;
  EXPECT_EQ(words_of(std::make_shared<MemorySource>(bytes), &damages), "!");
  EXPECT_EQ(damages[0], "memory: channel 3 is not described: its messages are left out");
}

std::string words_from(McapReader& reader, std::uint64_t capture_ns) {
  const auto sought = reader.seek(capture_ns);
  if (!sought) return sought.error();
  std::string words;
  while (true) {
    const auto message = reader.next();
    if (!message) return words + "! ";
    if (!*message) return words;
    words += (*message)->record.bytes + " ";
  }
}

TEST(McapReader, SeeksTheFirstMessageOfATime) {
  McapReader reader(McapText("one two | three | four").source());
  EXPECT_EQ(words_from(reader, 0), "one two three four ");
  EXPECT_EQ(words_from(reader, 20), "two three four ");
  EXPECT_EQ(words_from(reader, 21), "three four ");
  EXPECT_EQ(words_from(reader, 41), "");
  EXPECT_EQ(words_from(reader, 10), "one two three four ");
}

TEST(McapReader, SeeksInAnInterruptedFile) {
  McapReader reader(McapText("one two | three", {}, /*finished=*/false).source());
  EXPECT_EQ(words_from(reader, 20), "two three ! ");
  EXPECT_EQ(words_from(reader, 30), "three ! ");
}

}  // namespace
}  // namespace robot::logging
