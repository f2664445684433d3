#include "robot/app/played_range.h"

#include <gtest/gtest.h>

#include "robot/core/byte_sink.h"
#include "robot/core/byte_source.h"
#include "robot/logging/mcap/reader.h"
#include "robot/logging/mcap/writer.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/times.h"

namespace robot::app {
namespace {

using tests::kNow;

struct PlayedRange : testing::Test {
  PlayedRange() {
    auto writer = logging::SessionWriter::create(folder / "recorded", {.robot = "14/2", .team = 14, .player = 2});
    EXPECT_TRUE(writer);
    for (std::uint64_t i = 0; i < 100; ++i)
      EXPECT_TRUE(
          (*writer)->write({.topic = "/14/2/x", .message_encoding = "json", .schema = {}}, at(i), std::to_string(i)));
    for (std::uint64_t i = 0; i < 40; ++i)  // 20 MB, two messages of each time
      EXPECT_TRUE((*writer)->write({.topic = "/14/2/large", .message_encoding = "json", .schema = {}}, at(i / 2),
                                   std::string(512 * 1024, 'x')));
    EXPECT_TRUE((*writer)->close());
    auto opened = body::Replay::open({folder / "recorded"}, {.shifts = {kShift}});
    EXPECT_TRUE(opened) << opened.error();
    replay = std::move(*opened);
  }
  static std::uint64_t at(std::uint64_t i) { return kNow + i * kSecond; }
  /// Returns the time of message `i` by the clock of the playback.
  static std::uint64_t played(std::uint64_t i) { return at(i) + static_cast<std::uint64_t>(kShift); }

  struct Answer {
    std::vector<std::uint64_t> times_ns;
    std::vector<std::string> bytes;
    std::uint64_t until_ns = 0;
  };
  Answer ask(const std::string& topic, std::uint64_t from_ns, std::uint64_t to_ns) const {
    const net::HttpResponse response = played_range(*replay, {.topic = topic, .from_ns = from_ns, .to_ns = to_ns});
    EXPECT_EQ(response.status, 200);
    Answer answer;
    for (const auto& [name, value] : response.headers)
      if (name == net::kPlayedUntil) answer.until_ns = std::stoull(value);
    logging::McapReader reader(std::make_shared<MemorySource>(std::get<std::string>(response.body)));
    while (true) {
      const auto message = reader.next();
      if (!message || !*message) return answer;
      EXPECT_EQ(reader.channels().begin()->second.topic, topic);
      answer.times_ns.push_back((*message)->record.capture_ns);
      answer.bytes.push_back((*message)->record.bytes);
    }
  }

  static constexpr std::int64_t kShift = -350'000'000;
  const tests::TemporaryFolder folder;
  std::unique_ptr<body::Replay> replay;
};

TEST_F(PlayedRange, ContainsTheMessagesOfTheRangeIncludingBothEnds) {
  const Answer some = ask("/14/2/x", played(10), played(12));
  EXPECT_EQ(some.times_ns, (std::vector<std::uint64_t>{played(10), played(11), played(12)}));
  EXPECT_EQ(some.bytes, (std::vector<std::string>{"10", "11", "12"}));
  EXPECT_EQ(some.until_ns, played(12));
  EXPECT_EQ(ask("/14/2/x", 0, UINT64_MAX).times_ns.size(), 100u);
  EXPECT_EQ(ask("/14/2/x", played(10) + 1, played(11) - 1).times_ns.size(), 0u);
  EXPECT_EQ(ask("/14/2/x", played(200), UINT64_MAX).times_ns.size(), 0u);
}

TEST_F(PlayedRange, ALargeRangeTakesSeveralAnswers) {
  std::vector<std::uint64_t> times_ns;
  std::uint64_t from_ns = 0;
  int answers = 0;
  while (from_ns <= played(99)) {
    const Answer part = ask("/14/2/large", from_ns, played(99));
    EXPECT_LT(part.times_ns.size(), 30u);
    times_ns.insert(times_ns.end(), part.times_ns.begin(), part.times_ns.end());
    ASSERT_GE(part.until_ns, from_ns);
    from_ns = part.until_ns + 1;
    ++answers;
  }
  ASSERT_EQ(times_ns.size(), 40u);
  for (std::uint64_t i = 0; i < 40; ++i) EXPECT_EQ(times_ns[i], played(i / 2));
  EXPECT_GT(answers, 1);
}

TEST_F(PlayedRange, ATopicThatIsNotPlayedGives404) {
  EXPECT_EQ(played_range(*replay, {.topic = "/14/2/y"}).status, 404);
}

TEST(PlayedRangeOfAFile, BeginsWithAllMessagesOfTimeZero) {
  const tests::TemporaryFolder folder;
  const memory::ChannelInfo info{.topic = "/theirs", .message_encoding = "json", .schema = {}};
  auto writer = logging::McapWriter::open(std::move(*FileSink::create(folder / "theirs.mcap")), {&info, 1}, {});
  ASSERT_TRUE(writer);
  for (const std::uint64_t time_ns : {0, 0, 0, 5})
    ASSERT_TRUE(writer->write(0, {.capture_ns = time_ns, .publish_ns = time_ns, .bytes = "{}"}, 0));
  ASSERT_TRUE(writer->close());
  const auto replay = body::Replay::open({folder / "theirs.mcap"}, {});
  ASSERT_TRUE(replay) << replay.error();
  const net::HttpResponse response = played_range(**replay, {.topic = "/theirs", .from_ns = 0, .to_ns = 9});
  logging::McapReader reader(std::make_shared<MemorySource>(std::get<std::string>(response.body)));
  for (const std::uint64_t time_ns : {0, 0, 0, 5}) EXPECT_EQ((*reader.next())->record.capture_ns, time_ns);
}

}  // namespace
}  // namespace robot::app
