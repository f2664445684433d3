#include "robot/logging/sessions/stream_name.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace robot::logging {
namespace {

TEST(StreamNames, AreReadableForOrdinaryTopics) {
  EXPECT_EQ(stream_file_name("/14/2/ball"), "14.2.ball.mcap");
  EXPECT_EQ(stream_file_name("/14/2/camera_top"), "14.2.camera_top.mcap");
  EXPECT_EQ(stream_file_name("/14/2/MyMap"), "14.2.--my--map.mcap");
  EXPECT_EQ(stream_file_name("/debug/a/b"), "debug.a.b.mcap");
  EXPECT_EQ(stream_file_name("/debug/a.b"), "debug.a-2eb.mcap");
}

TEST(StreamNames, HoldOnlySafeCharactersAndBeginWithNoDot) {
  EXPECT_EQ(stream_file_name("/../../etc/passwd"), "-2e-2e.-2e-2e.etc.passwd.mcap");
  EXPECT_EQ(stream_file_name("/a b\n\"<>"), "a-20b-0a-22-3c-3e.mcap");
  EXPECT_EQ(stream_file_name("//a"), "-2fa.mcap");
  EXPECT_EQ(stream_file_name("/"), "-.mcap");
  EXPECT_EQ(stream_file_name(""), "-_.mcap");
  for (int byte = 0; byte < 256; ++byte) {
    const std::string name = stream_file_name("/" + std::string(1, static_cast<char>(byte)));
    EXPECT_NE(name.front(), '.');
    EXPECT_TRUE(std::ranges::all_of(name, [](unsigned char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
    })) << name;
  }
}

/// Returns many topics that resemble each other: of few characters, short and long.
std::vector<std::string> similar_topics() {
  std::vector<std::string> topics{"", "/", "//", "a", "/a", "/A", "//a", "/a/", "/ü", "/ö", "/debug/a/b", "/debug/a.b"};
  std::mt19937 random(1);
  constexpr std::string_view letters = "aA./_-2e\xc3";
  for (int i = 0; i < 20'000; ++i) {
    std::string topic(random() % 8 + (i % 10 == 0 ? 300 : 0), 'x');
    for (char& c : topic) c = letters[random() % letters.size()];
    topics.push_back(topic);
  }
  // long topics that differ only in one byte
  const std::string longest = "/" + std::string(500, 'a');
  for (std::size_t i = 0; i <= 500; ++i) {
    topics.push_back(longest);
    topics.back()[i] = 'b';
  }
  return topics;
}

// the names hold no upper-case letter, so that equal without case is equal
TEST(StreamNames, OfTwoTopicsAreNeverTheSame) {
  std::map<std::string, std::string> topic_of;
  for (const std::string& topic : similar_topics()) {
    const auto [known, added] = topic_of.emplace(stream_file_name(topic), topic);
    EXPECT_EQ(known->second, topic) << known->first;
  }
}

TEST(StreamNames, AreAtMostTwoHundredBytesLong) {
  for (const std::size_t size : {1u, 194u, 195u, 196u, 197u, 5'000u}) {
    EXPECT_LE(stream_file_name("/" + std::string(size, 'a')).size(), kMaxStreamName);
    EXPECT_LE(stream_file_name("/" + std::string(size, '\xff')).size(), kMaxStreamName);
    EXPECT_LE(stream_file_name(std::string(size, 'Z')).size(), kMaxStreamName);
  }
  EXPECT_EQ(stream_file_name("/" + std::string(195, 'a')), std::string(195, 'a') + ".mcap");
}

}  // namespace
}  // namespace robot::logging
