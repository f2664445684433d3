#include "robot/logging/mcap/ordered_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "robot/logging/mcap/compression.h"
#include "robot/logging/mcap/topic_streams.h"
#include "tests/support/mcap_bytes.h"
#include "tests/support/mcap_generator.h"
#include "tests/support/mcap_text.h"

namespace robot::logging {
namespace {

using tests::GeneratedMcap;
using tests::GeneratedMessage;
using tests::McapText;

constexpr std::uint32_t kFiles = 300;

std::shared_ptr<const McapFile> opened(std::string bytes) {
  auto file = McapFile::open(std::make_shared<MemorySource>(std::move(bytes)));
  EXPECT_TRUE(file) << file.error();
  return *file;
}

GeneratedMessage generated(const McapMessage& message) {
  return {.channel = message.channel_id,
          .sequence = static_cast<std::uint32_t>(message.record.sequence),
          .log_ns = message.record.capture_ns,
          .publish_ns = message.record.publish_ns,
          .data = message.record.bytes};
}

/// Reads to the end. `damages` counts the errors.
std::vector<GeneratedMessage> all_of(OrderedReader& reader, std::vector<std::string>* damages = nullptr) {
  std::vector<GeneratedMessage> messages;
  while (true) {
    const auto message = reader.next();
    if (message && !*message) return messages;
    if (message)
      messages.push_back(generated(**message));
    else if (damages)
      damages->push_back(message.error());
  }
}

TEST(OrderedReader, ReadsWhatOtherWritersWriteInTheOrderOfTheTimes) {
  for (std::uint32_t seed = 0; seed < kFiles; ++seed) {
    const GeneratedMcap made = tests::generate_mcap(seed);
    const auto file = opened(made.bytes);
    OrderedReader reader(file);
    std::vector<std::string> damages;
    ASSERT_EQ(all_of(reader, &damages), made.messages) << seed << ": " << made.features;
    std::uint64_t counted = 0;
    for (const TopicStream& stream : topic_streams(file->index())) counted += stream.messages + stream.left_out;
    EXPECT_EQ(counted, made.messages.size()) << seed << ": " << made.features;
    // the file is not silent about messages that are left out
    const bool is_silent = file->index().damage.empty() && damages.empty();
    EXPECT_TRUE(made.unreadable == 0 || !is_silent) << seed << ": " << made.features;
    EXPECT_TRUE(!made.is_valid || is_silent) << seed << ": " << made.features << ": " << file->index().damage;
  }
}

TEST(OrderedReader, HoldsAPartOfEachChunkIfTheyDoNotFit) {
  for (std::uint32_t seed = 0; seed < kFiles; ++seed) {
    const GeneratedMcap made = tests::generate_mcap(seed);
    OrderedReader reader(opened(made.bytes), {}, nullptr, /*open_bytes=*/0);
    ASSERT_EQ(all_of(reader), made.messages) << seed << ": " << made.features;
  }
}

TEST(OrderedReader, ContinuesAtAnyTime) {
  for (std::uint32_t seed = 0; seed < kFiles; seed += 3) {
    const GeneratedMcap made = tests::generate_mcap(seed);
    OrderedReader reader(opened(made.bytes));
    for (std::size_t i = 0; i < made.messages.size(); i += 1 + made.messages.size() / 5) {
      const std::uint64_t to_ns = made.messages[made.messages.size() - 1 - i].log_ns;
      reader.seek(to_ns);
      const auto first = std::ranges::lower_bound(made.messages, to_ns, {}, &GeneratedMessage::log_ns);
      ASSERT_EQ(all_of(reader), std::vector(first, made.messages.end())) << seed << ": " << made.features;
    }
  }
}

TEST(OrderedReader, FindsTheNewestMessageOfEachChannelAtAnyTime) {
  for (std::uint32_t seed = 0; seed < kFiles; ++seed) {
    const GeneratedMcap made = tests::generate_mcap(seed);
    OrderedReader reader(opened(made.bytes));
    for (std::size_t i = 0; i < made.messages.size(); i += 1 + made.messages.size() / 5) {
      const std::uint64_t to_ns = made.messages[i].log_ns + i % 2;
      std::map<std::uint16_t, GeneratedMessage> expected, found;
      for (const GeneratedMessage& message : made.messages)
        if (message.log_ns <= to_ns) expected[message.channel] = message;
      for (const McapMessage& message : reader.newest_until(to_ns)) {
        EXPECT_TRUE(found.emplace(message.channel_id, generated(message)).second);
      }
      ASSERT_EQ(found, expected) << seed << ": " << made.features;
    }
  }
}

TEST(OrderedReader, AMoveGivesTheNewestMessagesAndContinuesAfterThem) {
  for (std::uint32_t seed = 0; seed < kFiles; seed += 3) {
    const GeneratedMcap made = tests::generate_mcap(seed);
    OrderedReader reader(opened(made.bytes)), other(opened(made.bytes));
    std::vector<std::uint64_t> times{0, std::numeric_limits<std::uint64_t>::max()};
    for (std::size_t i = 0; i < made.messages.size(); i += 1 + made.messages.size() / 5)
      times.push_back(made.messages[i].log_ns);
    for (const std::uint64_t to_ns : times) {
      const std::vector<McapMessage> newest = reader.move_to(to_ns), expected = other.newest_until(to_ns);
      ASSERT_EQ(newest.size(), expected.size());
      for (std::size_t i = 0; i < newest.size(); ++i) ASSERT_EQ(generated(newest[i]), generated(expected[i]));
      const auto after = std::ranges::upper_bound(made.messages, to_ns, {}, &GeneratedMessage::log_ns);
      ASSERT_EQ(all_of(reader), std::vector(after, made.messages.end())) << seed << ": " << made.features;
    }
  }
}

TEST(OrderedReader, DeliversOnlyTheChosenChannels) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    GeneratedMcap made = tests::generate_mcap(seed);
    if (made.messages.empty()) continue;
    const std::uint16_t channel = made.messages.front().channel;
    OrderedReader reader(opened(made.bytes), std::set{channel});
    std::erase_if(made.messages, [&](const GeneratedMessage& message) { return message.channel != channel; });
    EXPECT_EQ(all_of(reader), made.messages) << seed;
  }
}

TEST(OrderedReader, EndsWhenItIsCancelledAndWhenItsFileIs) {
  const auto file = opened(McapText("one two | three").bytes);
  std::atomic<bool> cancelled = false;
  OrderedReader mine(file, {}, &cancelled), other(file);
  ASSERT_TRUE(*mine.next());
  cancelled = true;
  EXPECT_FALSE(*mine.next());
  EXPECT_TRUE(mine.newest_until(30).empty());
  ASSERT_TRUE(*other.next());
  file->end_reading();
  EXPECT_FALSE(*other.next());
}

TEST(OrderedReader, ReportsADamagedChunkOnceAndReadsTheRest) {
  McapText text("one two | three | four");
  text.increment_byte(text.chunks()[1] + 9 + 40 + 31);  // in the word "three"
  OrderedReader reader(opened(text.bytes));
  for (const std::size_t reported : {1u, 0u}) {
    std::vector<std::string> damages;
    EXPECT_EQ(all_of(reader, &damages).size(), 3u);
    ASSERT_EQ(damages.size(), reported);
    const std::string expected =
        "memory: Chunk at byte " + std::to_string(text.chunks()[1]) + ": its checksum is wrong, it is damaged";
    EXPECT_TRUE(damages.empty() || damages[0] == expected) << damages[0];
    reader.seek(0);
  }
}

TEST(OrderedReader, RefusesAChunkThatExpandsToGigabytes) {
  // 400 kB of zstd that are 12 GB of zeros; the head admits it, or lies
  const std::string zeros(std::size_t{8} << 20, 0);
  Compressor compressor(Compression::zstd);
  std::string frame, packed;
  const std::string_view piece = zeros;
  ASSERT_TRUE(compressor.compress({&piece, 1}, frame));
  while (packed.size() < 400'000) packed += frame;
  for (const std::uint64_t told : {std::uint64_t{1} << 31, std::uint64_t{1000}}) {
    tests::McapBytes file;
    file.raw(mcap::kMagic).record(0x01, tests::McapBytes().text("").text(""));
    const std::uint64_t offset = file.size();
    file.record(0x06, tests::McapBytes().u64(1).u64(1).u64(told).u32(0).text("zstd").u64(packed.size()).raw(packed));
    const auto opened = McapFile::open(std::make_shared<MemorySource>(file.bytes()));
    ASSERT_TRUE(opened);
    EXPECT_TRUE((*opened)->index().chunks.empty());
    const std::string why = told > 1000 ? "expected at most 67108864 bytes unpacked, got 2147483648"
                                        : "zstd: expected 1000 bytes, got more";
    EXPECT_NE((*opened)->index().damage.find("Chunk at byte " + std::to_string(offset) + ": " + why), std::string::npos)
        << (*opened)->index().damage;
  }
}

}  // namespace
}  // namespace robot::logging
