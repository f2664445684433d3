#include "robot/app/recording_playback.h"

#include <gtest/gtest.h>

#include <vector>

#include "robot/logging/sessions/session_writer.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/times.h"

namespace robot::app {
namespace {

using Status = net::foxglove::Playback;

using tests::kNow;

constexpr std::uint64_t kEnd = kNow + 2 * kSecond;

struct PlaybackOfARecording : testing::Test {
  PlaybackOfARecording() {
    auto writer = logging::SessionWriter::create(folder / "recorded", {.robot = "14/2", .team = 14, .player = 2});
    for (const std::uint64_t time_ns : {kNow, kEnd})
      EXPECT_TRUE((*writer)->write(info, time_ns, std::to_string(time_ns)));
    EXPECT_TRUE((*writer)->close());
    auto opened = body::Replay::open({folder / "recorded"}, {});
    EXPECT_TRUE(opened) << opened.error();
    replay = std::move(*opened);
  }
  const memory::ChannelInfo info{.topic = "/14/2/x", .message_encoding = "json", .schema = {}};
  const tests::TemporaryFolder folder;
  std::unique_ptr<body::Replay> replay;
};

TEST_F(PlaybackOfARecording, AnOwnPlayheadIsPausedWhereItIsAskedFor) {
  RecordingPlayback playback(*replay, 4, false);
  const auto own = playback.own_playhead(kNow + kSecond);
  ASSERT_TRUE(own) << own.error();
  EXPECT_EQ((*own)->state().status, Status::paused);
  EXPECT_EQ((*own)->state().time_ns, kNow + kSecond);
  EXPECT_EQ((*own)->state().speed, 4);
  // outside of the recording or without a time, at its start
  for (const std::optional<std::uint64_t> from_ns : {std::optional<std::uint64_t>(7), {}, {UINT64_MAX}})
    EXPECT_EQ((*playback.own_playhead(from_ns))->state().time_ns, kNow);
}

TEST_F(PlaybackOfARecording, AnOwnPlayheadMovesNoOther) {
  RecordingPlayback playback(*replay, 1, false);
  const auto own = playback.own_playhead({}), other = playback.own_playhead({});
  EXPECT_TRUE((*own)->control({.play = false, .speed = 1, .seek_ns = kNow + kSecond, .request_id = ""}));
  EXPECT_EQ((*own)->state().time_ns, kNow + kSecond);
  EXPECT_EQ((*other)->state().time_ns, kNow);
  EXPECT_EQ(playback.state().time_ns, kNow);
}

TEST_F(PlaybackOfARecording, PlayAtTheEndBeginsAgain) {
  RecordingPlayback playback(*replay, 1, false);
  const auto own = playback.own_playhead(kEnd);
  EXPECT_TRUE((*own)->control({.play = true, .speed = 0.01F, .seek_ns = {}, .request_id = ""}));
  EXPECT_LT((*own)->state().time_ns, kEnd);
}

TEST_F(PlaybackOfARecording, AnOwnPlayheadEndsOrBeginsAgainInALoop) {
  for (const bool loops : {false, true}) {
    RecordingPlayback playback(*replay, 1, loops);
    const auto own = playback.own_playhead({});
    ASSERT_TRUE((*own)->watch(info));
    static_cast<void>((*own)->control({.play = true, .speed = 1000, .seek_ns = {}, .request_id = ""}));
    if (loops) {
      EXPECT_TRUE(tests::eventually([&] { return (*own)->loop(); }));
    } else {
      EXPECT_TRUE(tests::eventually([&] { return (*own)->state().status == Status::ended; }));
      EXPECT_FALSE((*own)->loop());
    }
  }
}

TEST_F(PlaybackOfARecording, TheNumberOfOwnPlayheadsIsBounded) {
  RecordingPlayback playback(*replay, 1, false);
  std::vector<std::unique_ptr<net::OwnPlayhead>> all;
  for (int i = 0; i < kMostOwnPlayheads; ++i) {
    auto own = playback.own_playhead({});
    ASSERT_TRUE(own) << own.error();
    all.push_back(std::move(*own));
  }
  EXPECT_EQ(playback.own_playhead({}).error(),
            "16 pages have a playhead of their own, and there are no more: this one follows the shared playback");
  all.pop_back();
  EXPECT_TRUE(playback.own_playhead({}));
}

}  // namespace
}  // namespace robot::app
