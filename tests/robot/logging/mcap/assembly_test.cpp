#include "robot/logging/mcap/assembly.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "robot/logging/mcap/index.h"
#include "tests/support/mcap_text.h"

namespace robot::logging {
namespace {

using tests::all_bytes;
using tests::words_of;
using Sources = std::vector<std::shared_ptr<const ByteSource>>;

/// One stream with two words in each chunk. The first is captured at `first_ns`, the others `step_ns` apart.
std::string stream(std::uint16_t channel, const std::string& words, std::uint64_t first_ns, std::uint64_t step_ns,
                   bool finished = true, Compression compression = Compression::none) {
  tests::Disk disk;
  const McapOptions options{
      .first_channel_id = channel, .metadata = {{"session", {{"team", "14"}}}}, .compression = compression};
  McapWriter writer = tests::writer_to(disk, options, "/14/2/word" + std::to_string(channel));
  std::istringstream in(words);
  std::uint64_t at_ns = first_ns;
  int count = 0;
  for (std::string word; in >> word; at_ns += step_ns) {
    EXPECT_TRUE(writer.write(0, tests::word(word, at_ns), 0));
    EXPECT_TRUE(++count % 2 == 1 || writer.flush());
  }
  EXPECT_TRUE(finished ? writer.close() : writer.flush());
  return disk.bytes;
}

std::shared_ptr<const ByteSource> named(std::string bytes, std::string name) {
  return std::make_shared<MemorySource>(std::move(bytes), std::move(name));
}

/// Three streams: a* every 10 ns, B* every 20 ns, c* of a writer that died.
Sources session() {
  return {named(stream(1, "a10 a20 a30 a40 a50 a60", 10, 10), "a.mcap"),
          named(stream(2, "B15 B35 B55", 15, 20, true, Compression::zstd), "b.mcap"),
          named(stream(3, "c5 c25 c45 c65", 5, 20, false), "c.mcap")};
}

/// Returns the words of an assembly. The test fails if the assembly fails.
std::string assembled(Sources files, const AssemblyOptions& options = {}) {
  auto assembly = assemble(std::move(files), options);
  if (!assembly) return assembly.error();
  return words_of(std::make_shared<Assembly>(std::move(*assembly)));
}

TEST(Assembly, HoldsTheChunksOfAllFilesInTheOrderOfTheirStart) {
  EXPECT_EQ(assembled(session()), "c5 c25 a10 a20 B15 B35 a30 a40 c45 c65 a50 a60 B55");
}

TEST(Assembly, OfATopicHoldsOnlyTheChunksWithIt) {
  EXPECT_EQ(assembled(session(), {.topic = "/14/2/word2"}), "B15 B35 B55");
  EXPECT_EQ(assembled(session(), {.topic = "/14/2/none"}), "");
  // the same from one file with all streams
  const auto whole = assemble(session());
  ASSERT_TRUE(whole);
  const auto one = named(all_bytes(*whole), "whole.mcap");
  EXPECT_EQ(assembled({one}, {.topic = "/14/2/word1"}), "a10 a20 a30 a40 a50 a60");
  EXPECT_EQ(assembled({one}, {.topic = "/14/2/word3"}), "c5 c25 c45 c65");
}

TEST(Assembly, IsAValidFileOfItsOwn) {
  const auto assembly = assemble(session());
  ASSERT_TRUE(assembly) << assembly.error();
  const auto index = read_index(*assembly);
  ASSERT_TRUE(index) << index.error();
  EXPECT_EQ(index->damage, "");
  EXPECT_TRUE(index->complete);
  EXPECT_EQ(index->statistics.messages, 13u);
  EXPECT_EQ(index->statistics.start_ns, 5u);
  EXPECT_EQ(index->statistics.end_ns, 65u);
  EXPECT_EQ(index->statistics.channel_messages, (mcap::Numbers<std::uint16_t>{{1, 6}, {2, 3}, {3, 4}}));
  EXPECT_EQ(index->metadata.size(), 1u);
  EXPECT_EQ(index->schemas.size(), 1u);
  EXPECT_EQ(index->channels.at(3).topic, "/14/2/word3");

  // each message index is at the offset in the summary, and belongs to the chunk before it
  for (const ChunkInfo& chunk : index->chunks) {
    const auto expected = index_messages(*assembly, chunk.index);
    ASSERT_TRUE(expected) << expected.error();
    std::string bytes;
    mcap::append(bytes, expected->at(0));
    ASSERT_EQ(chunk.index.message_index_bytes, bytes.size());
    EXPECT_EQ(*read_bytes(*assembly, chunk.index.message_indexes.at(0).second, bytes.size()), bytes);
  }
}

TEST(Assembly, NamesTheDamagedFile) {
  const auto assembly = assemble(session());
  EXPECT_EQ(assembly->damage(), "c.mcap: ends at byte " + std::to_string(session()[2]->size()) +
                                    " without a DataEnd: its writer was interrupted");
}

TEST(Assembly, OfOneStreamIsThatStream) { EXPECT_EQ(assembled({session()[1]}), "B15 B35 B55"); }

TEST(Assembly, OfNothingIsAValidFile) { EXPECT_EQ(assembled({}), ""); }

TEST(Assembly, OfTruncatedFilesHoldsEveryCompleteChunk) {
  const std::string whole = stream(1, "a10 a20 a30 a40", 10, 10);
  const auto index = read_index(MemorySource(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto assembly = assemble({named(whole.substr(0, size), "a.mcap"), session()[1]});
    if (!assembly) continue;  // not even a header
    std::string expected;
    for (const ChunkInfo& chunk : index->chunks)
      if (chunk.index.offset + chunk.index.record_bytes <= size)
        expected += chunk.index.start_ns == 10 ? "a10 a20 " : " a30 a40";
    std::string words = words_of(std::make_shared<Assembly>(*assembly));
    EXPECT_NE(assembly->damage(), "");
    EXPECT_EQ(words.find("a10 a20") != std::string::npos, expected.find("a10 a20") != std::string::npos) << size;
    EXPECT_EQ(words.find("a30 a40") != std::string::npos, expected.find("a30 a40") != std::string::npos) << size;
    EXPECT_EQ(words.find('!'), std::string::npos) << size << words;
    EXPECT_EQ(read_index(*assembly)->damage, "") << size;
  }
}

TEST(Assembly, ChoosesTheChunksThatOverlapATimeRange) {
  EXPECT_EQ(assembled(session(), {.from_ns = 20, .to_ns = 29}), "c5 c25 a10 a20 B15 B35");
  EXPECT_EQ(assembled(session(), {.from_ns = 60}), "c45 c65 a50 a60");
  EXPECT_EQ(assembled(session(), {.to_ns = 9}), "c5 c25");
  EXPECT_EQ(assembled(session(), {.from_ns = 100}), "");
  EXPECT_EQ(assembled(session(), {.until_ns = 40}), "c5 c25 a10 a20 B15 B35 a30 a40");
}

TEST(Assembly, PiecesTogetherAreTheWhole) {
  const auto assembly = assemble(session());
  const std::string whole = all_bytes(*assembly);
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    std::string together;
    while (together.size() < whole.size()) {
      const std::size_t length = std::min<std::size_t>(random() % 300, whole.size() - together.size());
      const auto piece = read_bytes(*assembly, together.size(), length);
      ASSERT_TRUE(piece) << piece.error();
      together += *piece;
    }
    EXPECT_EQ(together, whole);
  }
  EXPECT_FALSE(read_bytes(*assembly, whole.size(), 1));
  EXPECT_FALSE(read_bytes(*assembly, whole.size() + 1, 0));
  EXPECT_TRUE(read_bytes(*assembly, whole.size(), 0));
}

TEST(Assembly, OfALiveSessionStaysTheSameWhileItsFilesGrow) {
  // the same writers at two times; at the later time they are closed
  const Sources early = {named(stream(1, "a10 a20 a30 a40", 10, 10, false), "a.mcap"),
                         named(stream(2, "B15 B35", 15, 20, false), "b.mcap")};
  const Sources later = {named(stream(1, "a10 a20 a30 a40 a50 a60", 10, 10), "a.mcap"),
                         named(stream(2, "B15 B35 B55 B75", 15, 20, false), "b.mcap")};
  const auto first = assemble(early, {.until_ns = 40}), second = assemble(later, {.until_ns = 40});
  EXPECT_EQ(all_bytes(*first), all_bytes(*second));
  EXPECT_EQ(first->etag(), second->etag());
  EXPECT_EQ(first->damage(), "");
}

TEST(Assembly, OfALiveSessionLeavesOutAChunkThatIsBeingWritten) {
  const std::string whole = stream(1, "a10 a20 a30 a40", 10, 10, false);
  const auto last = read_index(MemorySource(whole))->chunks.back().index;
  for (std::size_t size = last.offset; size < whole.size(); ++size)
    EXPECT_EQ(assembled({named(whole.substr(0, size), "a.mcap")}, {.until_ns = 40}), "a10 a20") << size;
}

TEST(Assembly, TheTagDependsOnTheContent) {
  EXPECT_EQ(assemble(session())->etag(), assemble(session())->etag());
  EXPECT_NE(assemble(session())->etag(), assemble(session(), {.until_ns = 40})->etag());
  EXPECT_NE(assemble({session()[0]})->etag(), assemble({session()[1]})->etag());
  EXPECT_NE(assemble({session()[0]})->etag(), assemble({named(all_bytes(*session()[0]), "other")})->etag());
}

TEST(Assembly, RefusesTwoChannelsWithOneId) {
  EXPECT_EQ(assembled({session()[0], named(stream(1, "x y", 1, 1), "x.mcap")}),
            "a.mcap and x.mcap: cannot be assembled: both use channel id 1");
}

TEST(Assembly, RefusesAFileThatIsNotMcap) {
  EXPECT_EQ(assembled({named("hello", "x.mcap")}), "x.mcap: not an MCAP file: expected the magic bytes at its start");
}

}  // namespace
}  // namespace robot::logging
