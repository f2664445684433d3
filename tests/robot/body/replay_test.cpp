// A recording that is played through live memory stays the same.
#include "robot/body/replay/replay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <new>

#include "proto/foresight/ball.pb.h"
#include "robot/body/replay/file_player.h"
#include "robot/core/byte_sink.h"
#include "robot/logging/mcap/writer.h"
#include "robot/logging/sessions/recorder.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/memory/memory.h"
#include "tests/support/eventually.h"
#include "tests/support/read_stream.h"
#include "tests/support/temporary_folder.h"

namespace robot::body {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kStart = 1'700'000'000 * kSecond;

struct Replaying : ::testing::Test {
  Replaying() {
    auto writer = logging::SessionWriter::create(recorded, {.robot = "14/2", .team = 14, .player = 2});
    const memory::ChannelInfo ball_info = memory::Memory("14/2", ManualClock()).ball.info();
    for (std::uint64_t i = 0; i < 300; ++i) {
      foresight::Ball ball;
      ball.set_x(static_cast<float>(i));
      EXPECT_TRUE((*writer)->write(ball_info, kStart + i * 10 * kMillisecond, ball.SerializeAsString()));
      if (i % 3 != 0) continue;
      EXPECT_TRUE((*writer)->write({.topic = "/14/2/vortex", .message_encoding = "json"},
                                   kStart + i * 10 * kMillisecond, "{\"unknown\": true}"));
    }
    EXPECT_TRUE((*writer)->close());
  }

  std::unique_ptr<Replay> open(ReplayOptions options) {
    auto replay = Replay::open({recorded}, std::move(options));
    EXPECT_TRUE(replay) << replay.error();
    return std::move(*replay);
  }

  /// Returns the capture time of a topic's newest message, or 0 if there is none.
  std::uint64_t newest_ns(const char* topic) const {
    const auto channel = channels.find(topic);
    const auto newest = channel ? channel->newest() : nullptr;
    return newest ? newest->capture_ns() : 0;
  }

  static void wait_for_the_end(Replay& replay) {
    ASSERT_TRUE(tests::eventually([&] { return replay.tick() != Replay::Tick::playing; }, tests::kLongestWait,
                                  [&] { return replay.messages(); }));
  }

  const tests::TemporaryFolder folder;
  const fs::path recorded = folder / "recorded", again = folder / "again";
  memory::Channels channels;
  logging::LoggingBoard board;
};

TEST_F(Replaying, GivesEachMessageToTheTypedMemoryAndOthersAChannelOfTheirOwn) {
  const auto replay = open({.speed = 100});
  const auto memory = std::make_shared<memory::Memory>("14/2", replay->clock());
  ASSERT_TRUE(list(memory, channels));
  ASSERT_TRUE(replay->start(channels, board));
  wait_for_the_end(*replay);
  EXPECT_EQ(memory->ball.read()->value().x(), 299);
  EXPECT_EQ(memory->ball.read()->capture_ns(), kStart + 2990 * kMillisecond);
  EXPECT_EQ(channels.find("/14/2/vortex")->newest()->bytes(), "{\"unknown\": true}");
  EXPECT_EQ(replay->messages(), 400u);
}

TEST_F(Replaying, RecordedAnewIsTheSame) {
  const auto replay = open({.speed = 20});
  const auto memory = std::make_shared<memory::Memory>("14/2", replay->clock());
  ASSERT_TRUE(list(memory, channels));
  logging::SessionStore store(again, 1'000'000'000'000);
  logging::Recorder recorder(channels, board, store, replay->clock(), {});
  const Result<std::string> session = recorder.start("", "full");
  ASSERT_TRUE(session) << session.error();
  ASSERT_TRUE(replay->start(channels, board));
  wait_for_the_end(*replay);
  ASSERT_TRUE(recorder.stop());
  for (const char* file : {"14.2.ball.mcap", "14.2.vortex.mcap"}) {
    const auto before = tests::read_stream(recorded / file), after = tests::read_stream(again / *session / file);
    ASSERT_EQ(before.size(), after.size()) << file;
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(before[i].bytes, after[i].bytes);
      EXPECT_EQ(before[i].capture_ns, after[i].capture_ns);
      EXPECT_EQ(after[i].sequence, i + 1);
    }
  }
}

TEST_F(Replaying, KeepsThePaceOfTheCaptureTimes) {
  const auto replay = open({.speed = 5});
  ASSERT_TRUE(replay->start(channels, board));
  const std::uint64_t began = monotonic_ns();
  wait_for_the_end(*replay);
  // never early; the delay depends on the machine
  EXPECT_GE(monotonic_ns() - began + 50 * kMillisecond, 2990 * kMillisecond / 5);
}

TEST_F(Replaying, ItsClockIsTheTimeOfTheRecording) {
  const auto replay = open({.speed = 100});
  EXPECT_EQ(replay->clock().now_ns(), kStart);
  ASSERT_TRUE(replay->start(channels, board));
  wait_for_the_end(*replay);
  EXPECT_LE(replay->clock().now_ns(), kStart + 2990 * kMillisecond);
  replay->stop();
  EXPECT_EQ(replay->clock().now_ns(), kStart + 2990 * kMillisecond);
}

TEST_F(Replaying, RestartsAtTheEndInALoop) {
  const auto replay = open({.speed = 1000, .loop = true});
  ASSERT_TRUE(replay->start(channels, board));
  EXPECT_TRUE(tests::eventually([&] { return replay->tick() == Replay::Tick::began_again; }));
}

/// Waits until the newest ball is at `x`.
void wait_for_ball(const memory::Memory& memory, float x) {
  const auto newest = [&] { return memory.ball.read() ? memory.ball.read()->value().x() : -1.0f; };
  ASSERT_TRUE(tests::eventually_equal(newest, x));
}

TEST_F(Replaying, StopsWherePausedAndContinues) {
  const auto replay = open({.speed = 1});
  const auto memory = std::make_shared<memory::Memory>("14/2", replay->clock());
  ASSERT_TRUE(list(memory, channels));
  ASSERT_TRUE(replay->start(channels, board));
  replay->clock().set(false, 1);
  const std::uint64_t paused = replay->clock().now_ns();
  replay->clock().seek(paused);
  EXPECT_EQ(replay->clock().now_ns(), paused);
  EXPECT_FALSE(replay->clock().running());
  replay->clock().set(true, 1000);
  wait_for_the_end(*replay);
  EXPECT_EQ(memory->ball.read()->value().x(), 299);
}

TEST_F(Replaying, AfterASeekEveryObjectHasItsValueOfThatTime) {
  const auto replay = open({.speed = 1});
  const auto memory = std::make_shared<memory::Memory>("14/2", replay->clock());
  ASSERT_TRUE(list(memory, channels));
  ASSERT_TRUE(replay->start(channels, board));
  replay->clock().set(false, 1);
  for (const std::uint64_t i : {200u, 3u, 299u, 0u, 150u}) {
    replay->clock().seek(kStart + i * 10 * kMillisecond + 5 * kMillisecond);
    wait_for_ball(*memory, static_cast<float>(i));
    const std::uint64_t third = i - i % 3;  // the newest message of the other stream before it
    ASSERT_TRUE(tests::eventually_equal([&] { return newest_ns("/14/2/vortex"); }, kStart + third * 10 * kMillisecond));
  }
  // seeks beyond the ends stay within the recording
  replay->clock().seek(0);
  EXPECT_EQ(replay->clock().now_ns(), kStart);
  replay->clock().seek(UINT64_MAX);
  EXPECT_EQ(replay->clock().now_ns(), kStart + 2990 * kMillisecond);
  wait_for_ball(*memory, 299);
}

TEST_F(Replaying, AfterTheEndASeekPlaysItAgain) {
  const auto replay = open({.speed = 1000});
  const auto memory = std::make_shared<memory::Memory>("14/2", replay->clock());
  ASSERT_TRUE(list(memory, channels));
  ASSERT_TRUE(replay->start(channels, board));
  wait_for_the_end(*replay);
  replay->clock().set(false, 1000);
  replay->clock().seek(kStart);
  wait_for_ball(*memory, 0);
  replay->clock().set(true, 1000);
  wait_for_the_end(*replay);
  wait_for_ball(*memory, 299);
}

TEST_F(Replaying, SeveralRobotsAreMergedByTime) {
  auto writer = logging::SessionWriter::create(folder / "other", {.robot = "14/3"});
  ASSERT_TRUE((*writer)->write({.topic = "/14/3/vortex"}, kStart + kSecond, "early"));
  ASSERT_TRUE((*writer)->write({.topic = "/14/3/vortex"}, kStart + 9 * kSecond, "late"));
  ASSERT_TRUE((*writer)->close());
  auto replay = Replay::open({recorded, folder / "other"}, {.speed = 1});
  ASSERT_TRUE(replay) << replay.error();
  EXPECT_EQ((*replay)->robots(), (std::vector<std::string>{"14/2", "14/3"}));
  EXPECT_EQ((*replay)->start_ns(), kStart);
  EXPECT_EQ((*replay)->end_ns(), kStart + 9 * kSecond);
  ASSERT_TRUE((*replay)->start(channels, board));
  (*replay)->clock().set(false, 1);
  (*replay)->clock().seek(kStart + 2 * kSecond);
  ASSERT_TRUE(tests::eventually_equal([&] { return newest_ns("/14/3/vortex"); }, kStart + kSecond));
  ASSERT_TRUE(tests::eventually_equal([&] { return newest_ns("/14/2/ball"); }, kStart + 2 * kSecond));
  EXPECT_EQ(
      Replay::open({recorded, recorded}, {}).error(),
      "replay: expected recordings of different robots, " + recorded.string() + " has no topic beyond those before it");
}

TEST_F(Replaying, CanBeStoppedAtAnyTime) {
  const auto replay = open({.speed = 0.01});
  ASSERT_TRUE(replay->start(channels, board));
  replay->stop();
  EXPECT_LT(replay->messages(), 400u);
}

TEST_F(Replaying, SkipsObjectsThatThisProcessWrites) {
  const auto replay = open({.speed = 1000, .skipped_objects = {"ball"}});
  ASSERT_TRUE(replay->start(channels, board));
  wait_for_the_end(*replay);
  EXPECT_EQ(channels.find("/14/2/ball"), nullptr);
  EXPECT_NE(channels.find("/14/2/vortex"), nullptr);
}

TEST_F(Replaying, ShowsItsRobotUnderAnotherName) {
  const auto replay = open({.speed = 1000, .robot = "5/3"});
  ASSERT_TRUE(replay->start(channels, board));
  wait_for_the_end(*replay);
  EXPECT_EQ(channels.find("/14/2/ball"), nullptr);
  EXPECT_NE(channels.find("/5/3/ball"), nullptr);
}

TEST_F(Replaying, NamesTheError) {
  EXPECT_EQ(Replay::open({recorded}, {.speed = 0}).error(), "replay: speed must be 0.01 .. 1000, got 0.000000");
  EXPECT_EQ(Replay::open({folder / "none"}, {}).error(), "session " + (folder / "none").string() + ": cannot read " +
                                                             (folder / "none" / "session.json").string() +
                                                             ": No such file or directory");
  ASSERT_TRUE((*logging::SessionWriter::create(folder / "empty", {}))->close());
  EXPECT_EQ(Replay::open({folder / "empty"}, {}).error(),
            "replay: expected a session with messages, " + (folder / "empty").string() + " has none");
}

TEST_F(Replaying, ARecordingWhoseClockDriftsIsPlayedInTheTimeOfTheOther) {
  // a clock 0.35 s ahead, which gains 10 us in 10 ms
  const fs::path other = folder / "other";
  auto writer = logging::SessionWriter::create(other, {.robot = "14/3", .team = 14, .player = 3});
  const memory::ChannelInfo info = memory::Memory("14/3", ManualClock()).ball.info();
  constexpr std::uint64_t kAhead = 350 * kMillisecond, kStep = 10'010'000;
  for (std::uint64_t i = 0; i < 300; ++i) EXPECT_TRUE((*writer)->write(info, kStart + kAhead + i * kStep, ""));
  ASSERT_TRUE((*writer)->close());
  const ClockShift shift(-static_cast<std::int64_t>(kAhead), -10'000.0 / kStep, kStart + kAhead);
  const auto replay = Replay::open({recorded, other}, {.shifts = {0, shift}});
  ASSERT_TRUE(replay) << replay.error();
  std::uint64_t expected_ns = kStart + 100 * 10 * kMillisecond;
  EXPECT_EQ((*replay)->read({"/14/3/ball"}, expected_ns, UINT64_MAX,
                            [&](const Replay::Message& message) {
                              EXPECT_EQ(message.capture_ns, expected_ns);
                              expected_ns += 10 * kMillisecond;
                              return true;
                            }),
            0u);
  EXPECT_EQ(expected_ns, kStart + 300 * 10 * kMillisecond);
}

TEST_F(Replaying, ARecordingWhoseClockIsOffIsPlayedInTheTimeOfTheOther) {
  // another robot saw its ball at the same times, with a clock 0.35 s ahead
  const fs::path other = folder / "other";
  auto writer = logging::SessionWriter::create(other, {.robot = "14/3", .team = 14, .player = 3});
  const memory::ChannelInfo info = memory::Memory("14/3", ManualClock()).ball.info();
  constexpr std::uint64_t kAhead = 350 * kMillisecond;
  for (std::uint64_t i = 0; i < 300; ++i) {
    foresight::Ball ball;
    ball.set_seen_ns(kStart + kAhead + i * 10 * kMillisecond);
    EXPECT_TRUE((*writer)->write(info, kStart + kAhead + i * 10 * kMillisecond, ball.SerializeAsString()));
  }
  ASSERT_TRUE((*writer)->close());
  auto replay = Replay::open({recorded, other}, {.speed = 1000, .shifts = {0, -static_cast<std::int64_t>(kAhead)}});
  ASSERT_TRUE(replay) << replay.error();
  EXPECT_EQ((*replay)->start_ns(), kStart);
  EXPECT_EQ((*replay)->end_ns(), kStart + 2990 * kMillisecond);
  ASSERT_TRUE((*replay)->start(channels, board));
  wait_for_the_end(**replay);
  const auto shown = [&] {
    foresight::Ball ball;
    EXPECT_TRUE(ball.ParseFromString(std::string(channels.find("/14/3/ball")->newest()->bytes())));
    return ball.seen_ns();
  };
  EXPECT_EQ(newest_ns("/14/3/ball"), newest_ns("/14/2/ball"));
  EXPECT_EQ(shown(), newest_ns("/14/3/ball")) << "times within messages are moved, too";
  // after every seek both show the same time
  (*replay)->clock().set(false, 1);
  (*replay)->clock().seek(kStart + 1000 * kMillisecond);
  for (const char* topic : {"/14/2/ball", "/14/3/ball"})
    ASSERT_TRUE(tests::eventually_equal([&] { return newest_ns(topic); }, kStart + 1000 * kMillisecond)) << topic;
  EXPECT_EQ(shown(), kStart + 1000 * kMillisecond);
}

/// One file with 1000 topics: a message of each every 10 ms, and one at time 0.
struct ReplayingAFile : Replaying {
  ReplayingAFile() {
    std::vector<memory::ChannelInfo> infos;
    for (int i = 0; i < kTopics; ++i) infos.push_back({.topic = topic(i), .message_encoding = "json", .schema = {}});
    auto sink = FileSink::create(file);
    auto writer = logging::McapWriter::open(std::move(*sink), infos, {});
    for (std::uint64_t i = 0; i < kCount; ++i)
      for (std::size_t channel = 0; channel < kTopics; ++channel)
        EXPECT_TRUE(writer->write(channel, message(i + 1, time(i), std::to_string(i)), 0));
    const std::string stray = "stray";
    EXPECT_TRUE(writer->write(0, message(kCount + 1, 0, stray), 0));
    EXPECT_TRUE(writer->close());
  }

  static logging::OutMessage message(std::uint64_t sequence, std::uint64_t time_ns, std::string_view bytes) {
    return {.sequence = sequence, .capture_ns = time_ns, .publish_ns = time_ns, .bytes = bytes};
  }
  static std::string topic(int i) { return "/theirs/" + std::to_string(i); }
  static std::uint64_t time(std::uint64_t i) { return kStart + i * 10 * kMillisecond; }

  static constexpr int kTopics = 1000;
  static constexpr std::uint64_t kCount = 50;
  const fs::path file = folder / "theirs.mcap";
};

TEST_F(ReplayingAFile, GivesEveryMessageOfEveryTopic) {
  auto replay = Replay::open({file}, {.speed = 100});
  ASSERT_TRUE(replay) << replay.error();
  ASSERT_TRUE((*replay)->start(channels, board));
  wait_for_the_end(**replay);
  EXPECT_EQ((*replay)->messages(), kTopics * kCount + 1);
  for (int i = 0; i < kTopics; ++i) EXPECT_EQ(newest_ns(topic(i).c_str()), time(kCount - 1)) << i;
  EXPECT_TRUE(board.statuses().empty()) << "one thread reads the file for all topics";
}

TEST_F(ReplayingAFile, LeavesStrayMessagesOutOfTheTimeLineAndSaysSo) {
  auto replay = Replay::open({file}, {});
  ASSERT_TRUE(replay) << replay.error();
  EXPECT_EQ((*replay)->start_ns(), kStart);
  EXPECT_EQ((*replay)->end_ns(), time(kCount - 1));
  EXPECT_EQ((*replay)->notes(), std::vector<std::string>{
                                    "1 message before 2023-11-14 22:13:20 UTC left out of the strip, because more than "
                                    "30 days lie between"});
}

/// A channel without memory for its first message.
class FullChannel final : public memory::Channel {
 public:
  explicit FullChannel(const Clock& clock) { announce({.topic = "/full"}, clock); }
  Result<void> write_bytes(std::string_view, std::uint64_t) override {
    if (messages++ == 0) throw std::bad_alloc();
    return {};
  }
  std::atomic<std::uint64_t> messages = 0;
};

TEST_F(ReplayingAFile, AnExceptionOfAChannelCostsOneMessage) {
  const auto opened = logging::McapFile::open(file);
  ASSERT_TRUE(opened);
  PlaybackClock clock(kStart, time(kCount - 1), 1000);
  const auto full = std::make_shared<FullChannel>(clock);
  std::vector<PlayedTopic> topics;
  topics.push_back({.channels = {1}, .to = full, .shift = nullptr});
  FilePlayer player(*opened, std::move(topics), 0, clock);
  clock.start();
  ASSERT_TRUE(player.start());
  EXPECT_TRUE(tests::eventually([&] { return full->messages == kCount + 1; }));
  clock.stop();
  player.stop();
  EXPECT_EQ(player.messages(), kCount);
}

TEST_F(ReplayingAFile, AfterASeekEveryTopicHasItsValueOfThatTime) {
  auto replay = Replay::open({file}, {.shifts = {5 * kMillisecond}});
  ASSERT_TRUE(replay) << replay.error();
  ASSERT_TRUE((*replay)->start(channels, board));
  (*replay)->clock().set(false, 1);
  for (const std::uint64_t i : {20u, 3u, 49u, 0u, 15u}) {
    (*replay)->clock().seek(time(i) + 9 * kMillisecond);
    for (const int of : {0, 42, 999})
      ASSERT_TRUE(tests::eventually_equal([&] { return newest_ns(topic(of).c_str()); }, time(i) + 5 * kMillisecond));
  }
}

TEST_F(ReplayingAFile, RestartsAtTheEndAndStopsAtAnyTime) {
  auto replay = Replay::open({file}, {.speed = 1000, .loop = true});
  ASSERT_TRUE(replay) << replay.error();
  ASSERT_TRUE((*replay)->start(channels, board));
  EXPECT_TRUE(tests::eventually([&] { return (*replay)->tick() == Replay::Tick::began_again; }));
  (*replay)->stop();
  const auto stream = (*replay)->stream_of(topic(1));
  ASSERT_TRUE(stream->open());
  EXPECT_FALSE(*stream->read()) << "a stopped playback ends also the readers of its file";
}

}  // namespace
}  // namespace robot::body
