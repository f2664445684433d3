#include "robot/logging/mcap/compression.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "tests/support/foreign_frames.h"

namespace robot::logging {
namespace {

constexpr Compression kAll[] = {Compression::none, Compression::lz4, Compression::zstd};

std::string some_bytes(std::mt19937& random, std::size_t size) {
  std::string bytes;
  while (bytes.size() < size) bytes.append(random() % 40, static_cast<char>(random()));
  bytes.resize(size);
  return bytes;
}

std::string packed(Compression compression, std::string_view bytes) {
  Compressor compressor(compression);
  std::string into;
  EXPECT_TRUE(compressor.compress({&bytes, 1}, into));
  return into;
}

TEST(Compression, RoundTripsGiveTheSameBytes) {
  std::mt19937 random(1);
  for (const Compression compression : kAll) {
    Compressor compressor(compression);
    for (const std::size_t size : {0u, 1u, 100u, 65536u, 70000u, 1000000u}) {
      const std::string first = some_bytes(random, size), second = some_bytes(random, size / 2);
      const std::vector<std::string_view> pieces = {first, {}, second};
      std::string small = "what was here before";
      ASSERT_TRUE(compressor.compress(pieces, small));
      const auto back = decompress(compression, small, first.size() + second.size());
      ASSERT_TRUE(back) << back.error();
      EXPECT_EQ(*back, first + second) << name(compression) << " " << size;
    }
  }
}

TEST(Compression, ReducesTheSize) {
  const std::string zeros(100'000, 0);
  EXPECT_LT(packed(Compression::lz4, zeros).size(), 1000u);
  EXPECT_LT(packed(Compression::zstd, zeros).size(), 100u);
}

TEST(Compression, RequiresExactlyTheExpectedSize) {
  const std::string bytes(1000, 'x');
  for (const Compression compression : kAll)
    for (const std::size_t size : {0u, 1u, 999u, 1001u, 100'000u})
      EXPECT_FALSE(decompress(compression, packed(compression, bytes), size)) << name(compression) << " " << size;
  EXPECT_EQ(decompress(Compression::zstd, packed(Compression::zstd, bytes), 1001).error(),
            "zstd: expected 1001 bytes, got 1000");
}

TEST(Compression, SurvivesEveryTruncationAndEveryBrokenByte) {
  std::mt19937 random(1);
  const std::string bytes = some_bytes(random, 300);
  for (const Compression compression : {Compression::lz4, Compression::zstd}) {
    const std::string small = packed(compression, bytes);
    for (std::size_t n = 0; n < small.size(); ++n) EXPECT_FALSE(decompress(compression, small.substr(0, n), 300)) << n;
    for (std::size_t i = 0; i < small.size(); ++i) {
      std::string broken = small;
      broken[i] = static_cast<char>(broken[i] ^ 0x55);
      const auto back =
          decompress(compression, broken, 300);  // may succeed: then the chunk's checksum finds the damage
      EXPECT_TRUE(!back || back->size() == 300) << i;
    }
    EXPECT_FALSE(decompress(compression, small + "x", 300));
  }
}

TEST(Compression, AFalseSizeCostsNoMemory) {
  EXPECT_FALSE(
      decompress(Compression::lz4, packed(Compression::lz4, "x"), std::numeric_limits<std::size_t>::max() / 2));
  EXPECT_FALSE(
      decompress(Compression::zstd, packed(Compression::zstd, "x"), std::numeric_limits<std::size_t>::max() / 2));
}

TEST(Compression, ReadsAnyLevelAndAnyNumberOfFrames) {
  std::mt19937 random(1);
  const std::string bytes = some_bytes(random, 3000);
  for (const Compression compression : {Compression::lz4, Compression::zstd})
    for (int level = 1; level <= (compression == Compression::lz4 ? 12 : 22); ++level)
      for (const int frames : {1, 2, 7}) {
        const tests::FrameOptions options{.compression = std::string(name(compression)),
                                          .level = level,
                                          .frames = frames,
                                          .skippable = level % 2 == 0,
                                          .content_size = level % 3 > 0,
                                          .checksum = level % 4 == 0};
        const auto back = decompress(compression, tests::foreign_frames(bytes, options, random), bytes.size());
        ASSERT_TRUE(back) << name(compression) << " " << level << ": " << back.error();
        EXPECT_EQ(*back, bytes);
      }
  // as the highest level does if it does not know the size
  const tests::FrameOptions wide{.compression = "zstd", .content_size = false, .window_log = 27};
  EXPECT_EQ(*decompress(Compression::zstd, tests::foreign_frames(bytes, wide, random), bytes.size()), bytes);
  EXPECT_EQ(*decompress(Compression::zstd, "", 0), "");
}

TEST(Compression, UsesTheNamesOfMcap) {
  for (const Compression compression : kAll) EXPECT_EQ(*compression_named(name(compression)), compression);
  EXPECT_EQ(compression_named("bz2").error(), "compression: expected \"\", \"lz4\" or \"zstd\", got \"bz2\"");
}

}  // namespace
}  // namespace robot::logging
