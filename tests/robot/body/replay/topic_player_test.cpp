// A playhead of its own plays the watched topics of a recording, and moves no other.
#include "robot/body/replay/topic_player.h"

#include <gtest/gtest.h>

#include "robot/core/byte_sink.h"
#include "robot/logging/mcap/writer.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"

namespace robot::body {
namespace {

constexpr std::uint64_t kFirst_ns = 1'700'000'000 * kSecond;
constexpr std::uint64_t at(std::uint64_t i) { return kFirst_ns + i * 10 * kMillisecond; }

/// 300 messages "0" to "299" of "/14/2/fast", every 10 ms, and each third of "/14/2/slow".
struct Topics : ::testing::Test {
  Topics() {
    auto writer = logging::SessionWriter::create(folder / "session", {.robot = "14/2", .team = 14, .player = 2});
    for (std::uint64_t i = 0; i < 300; ++i) {
      EXPECT_TRUE((*writer)->write(fast, at(i), std::to_string(i)));
      if (i % 3 != 0) continue;
      EXPECT_TRUE((*writer)->write(slow, at(i), std::to_string(i)));
    }
    EXPECT_TRUE((*writer)->close());
    auto sink = FileSink::create(folder / "file.mcap");
    const std::vector<memory::ChannelInfo> infos = {fast, slow};
    auto file = logging::McapWriter::open(std::move(*sink), infos, {});
    for (std::uint64_t i = 0; i < 300; ++i)
      for (std::size_t channel = 0; channel < (i % 3 == 0 ? 2u : 1u); ++channel) {
        const std::string text = std::to_string(i);
        EXPECT_TRUE(file->write(channel, {i, at(i), at(i), text}, at(i)));
      }
    EXPECT_TRUE(file->close());
  }
  std::unique_ptr<Replay> open(const char* name, std::int64_t shift_ns = 0) {
    auto replay = Replay::open({folder / name}, {.shifts = {shift_ns}});
    EXPECT_TRUE(replay) << replay.error();
    return std::move(*replay);
  }
  static std::string newest(const memory::Channel& channel) {
    const auto version = channel.newest();
    return version ? std::string(version->bytes()) : "";
  }

  const memory::ChannelInfo fast{.topic = "/14/2/fast", .message_encoding = "json", .schema = {}},
      slow{.topic = "/14/2/slow", .message_encoding = "json", .schema = {}};
  const tests::TemporaryFolder folder;
};

/// The same laws for a session of one file per object, and for one file with many topics.
struct EachRecording : Topics, testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Recordings, EachRecording, testing::Values("session", "file.mcap"));

TEST_P(EachRecording, BeginsPausedAndGivesATopicItsValueOfThatTime) {
  const auto replay = open(GetParam());
  TopicPlayer player(*replay, 1, at(100) + 1);
  ASSERT_TRUE(player.start());
  const auto channel = player.watch(fast);
  ASSERT_TRUE(tests::eventually_equal([&] { return newest(*channel); }, "100"));
  const auto other = player.watch(slow);
  ASSERT_TRUE(tests::eventually_equal([&] { return newest(*other); }, "99"));
  EXPECT_EQ(channel->newest()->sequence(), 1u) << "a topic that is watched already gets no message twice";
  EXPECT_EQ(player.clock().now_ns(), at(100) + 1);
}

TEST_P(EachRecording, AfterASeekEachWatchedTopicHasItsValueOfThatTime) {
  const auto replay = open(GetParam());
  TopicPlayer player(*replay, 1, 0);
  ASSERT_TRUE(player.start());
  const auto channel = player.watch(fast), other = player.watch(slow);
  for (const std::uint64_t i : {200u, 4u, 299u, 0u, 151u}) {
    player.seek(at(i));
    ASSERT_TRUE(tests::eventually_equal([&] { return newest(*channel); }, std::to_string(i)));
    ASSERT_TRUE(tests::eventually_equal([&] { return newest(*other); }, std::to_string(i - i % 3)));
  }
}

TEST_P(EachRecording, PlaysEveryMessageOfTheWatchedTopicsAtItsOwnTime) {
  const auto replay = open(GetParam());
  TopicPlayer player(*replay, 1, 0);
  ASSERT_TRUE(player.start());
  const auto channel = player.watch(fast), other = player.watch(slow);
  ASSERT_TRUE(tests::eventually_equal([&] { return newest(*other); }, "0"));
  EXPECT_FALSE(player.at_end());
  player.clock().set(true, 1000);
  ASSERT_TRUE(tests::eventually([&] { return player.at_end(); }));
  EXPECT_EQ(newest(*channel), "299");
  EXPECT_EQ(channel->newest()->sequence(), 300u);
  EXPECT_EQ(other->newest()->sequence(), 100u);
  EXPECT_EQ(channel->newest()->capture_ns(), at(299));
  // the recording's shared playback did not move
  EXPECT_EQ(replay->clock().now_ns(), kFirst_ns);
}

TEST_F(Topics, TwoPlayheadsOfARecordingAreIndependent) {
  const auto replay = open("session");
  TopicPlayer one(*replay, 1, at(10)), other(*replay, 1, at(20));
  ASSERT_TRUE(one.start());
  ASSERT_TRUE(other.start());
  const auto of_one = one.watch(fast), of_other = other.watch(fast);
  one.seek(at(50));
  ASSERT_TRUE(tests::eventually_equal([&] { return newest(*of_one); }, "50"));
  ASSERT_TRUE(tests::eventually_equal([&] { return newest(*of_other); }, "20"));
}

TEST_F(Topics, TimesAreThoseOfThePlayback) {
  const std::int64_t shift_ns = -350'000'000;
  for (const char* name : {"session", "file.mcap"}) {
    const auto replay = open(name, shift_ns);
    TopicPlayer player(*replay, 1, at(100) + static_cast<std::uint64_t>(shift_ns));
    ASSERT_TRUE(player.start());
    const auto channel = player.watch(fast);
    ASSERT_TRUE(tests::eventually_equal([&] { return newest(*channel); }, "100"));
    EXPECT_EQ(channel->newest()->capture_ns(), at(100) + static_cast<std::uint64_t>(shift_ns));
  }
}

TEST_F(Topics, SeveralWatchesShareAChannelAndTheLastOneEndsIt) {
  const auto replay = open("session");
  TopicPlayer player(*replay, 1, 0);
  ASSERT_TRUE(player.start());
  const auto first = player.watch(fast);
  EXPECT_EQ(player.watch(fast), first);
  player.unwatch(fast.topic);
  player.seek(at(7));
  ASSERT_TRUE(tests::eventually_equal([&] { return newest(*first); }, "7"));
  player.unwatch(fast.topic);
  player.unwatch(fast.topic);  // without effect
  const auto anew = player.watch(fast);
  EXPECT_NE(anew, first);
  ASSERT_TRUE(tests::eventually_equal([&] { return newest(*anew); }, "7"));
  player.seek(at(9));
  ASSERT_TRUE(tests::eventually_equal([&] { return newest(*anew); }, "9"));
  EXPECT_EQ(newest(*first), "7");
}

TEST_F(Topics, ATopicThatIsNotPlayedHasNoChannel) {
  const auto replay = open("session");
  TopicPlayer player(*replay, 1, 0);
  EXPECT_EQ(player.watch({.topic = "/14/2/other"}), nullptr);
}

TEST_F(Topics, AMadeStreamIsPlayedToo) {
  auto opened =
      Replay::open({folder / "session"},
                   {.made = {{.from = fast.topic, .to = "/14/2/made", .make = [](auto stream) { return stream; }}}});
  ASSERT_TRUE(opened) << opened.error();
  TopicPlayer player(**opened, 1, at(5));
  ASSERT_TRUE(player.start());
  const auto channel = player.watch({.topic = "/14/2/made", .message_encoding = "json"});
  ASSERT_TRUE(channel);
  ASSERT_TRUE(tests::eventually_equal([&] { return newest(*channel); }, "5"));
}

}  // namespace
}  // namespace robot::body
