// Recording of whole sessions: every message is readable afterwards, also after a full disk or a killed process.
#include "robot/logging/sessions/recorder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "proto/foresight/camera.pb.h"
#include "robot/core/byte_source.h"
#include "robot/core/files.h"
#include "robot/logging/mcap/index.h"
#include "robot/memory/memory.h"
#include "tests/support/read_stream.h"
#include "tests/support/recording.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

namespace fs = std::filesystem;
namespace pb = foresight;

using tests::kNow;
using tests::Recording;
using tests::SmallDisk;

TEST_F(Recording, KeepsEveryVersionOfEveryObject) {
  const Result<std::string> session = recorder.start("", "full");
  ASSERT_TRUE(session) << session.error();
  for (int i = 0; i < 100; ++i) write_ball(static_cast<float>(i));
  ASSERT_TRUE(recorder.stop());
  const std::vector<Record> records = ball_records(*session);
  ASSERT_EQ(records.size(), 100u);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].sequence, i + 1);
    EXPECT_EQ(records[i].capture_ns, kNow + i * 33 * kMillisecond);
    pb::Ball ball;
    ASSERT_TRUE(ball.ParseFromString(records[i].bytes));
    EXPECT_EQ(ball.x(), static_cast<float>(i));
  }
}

TEST_F(Recording, DescribesItself) {
  const std::string id = *recorder.start("first half", "game");
  EXPECT_EQ(id, "2023-11-14_22-13-20_first_half");
  EXPECT_EQ(store.find(id)->state, SessionState::recording);
  write_ball(1);
  ASSERT_TRUE(recorder.stop());
  const Result<Session> session = store.find(id);
  ASSERT_TRUE(session);
  EXPECT_EQ(session->state, SessionState::complete);
  EXPECT_EQ(session->info.name, "first half");
  EXPECT_EQ(session->info.robot, "14/2");
  EXPECT_EQ(session->info.build, "abc");
  EXPECT_EQ(session->info.profile, "game");
  EXPECT_EQ(session->start_ns, kNow);
  const auto ball = std::ranges::find(session->streams, "/14/2/ball", &StreamFile::topic);
  ASSERT_NE(ball, session->streams.end());
  EXPECT_EQ(ball->schema, "foresight.Ball");
  EXPECT_EQ(ball->messages, 1u);
}

// a robot's clock is often set only after its program began: a half was then told to begin three minutes early
TEST_F(Recording, SaysHowFarItsTimesAreBehindTheTimeOfDay) {
  std::int64_t behind_ns = 180 * static_cast<std::int64_t>(kSecond);
  Recorder set(channels, board, store, clock, {.info = {.robot = "14/2"}, .behind_ns = [&] { return behind_ns; }});
  const std::string id = *set.start("half", "game");
  EXPECT_EQ(id, "2023-11-14_22-16-20_half") << "the folder's name is the time of day";
  EXPECT_EQ(store.find(id)->info.behind_ns, behind_ns);
  write_ball(1);
  behind_ns -= 3;  // the newest is the best
  ASSERT_TRUE(set.stop());
  EXPECT_EQ(store.find(id)->info.behind_ns, behind_ns);
  EXPECT_EQ(store.find(id)->start_ns, kNow) << "the recorded times stay as they are";
  EXPECT_EQ(time_of_day_ns(store.find(id)->info), kNow + static_cast<std::uint64_t>(behind_ns));

  behind_ns = -999'999'999;
  const std::string agrees = *set.start("", "game");
  ASSERT_TRUE(set.stop());
  EXPECT_EQ(store.find(agrees)->info.behind_ns, 0) << "less than a second";
}

TEST_F(Recording, LearnsTheRulesOfTheGameOnceAlsoDuringASession) {
  const std::string id = *recorder.start("", "game");
  recorder.know_rules("spl2012:4");
  recorder.know_rules("spl2025");  // of another robot
  const auto late = tests::make_channel(clock, "/14/2/late");
  ASSERT_TRUE(channels.add(late));
  ASSERT_TRUE(late->write_bytes("appeared", clock.now_ns()));
  recorder.tend();
  EXPECT_EQ(parse_session_info(*read_file(folder.path() / id / "session.json", 1 << 20))->rules, "spl2012:4");
  ASSERT_TRUE(recorder.stop());
  EXPECT_EQ(store.find(id)->info.rules, "spl2012:4");
  EXPECT_EQ(session_info_in(read_index(**FileSource::open(folder.path() / id / "14.2.late.mcap"))->metadata)->rules,
            "spl2012:4")
      << "files that begin later have them too";
  const std::string next = *recorder.start("", "game");
  EXPECT_EQ(store.find(next)->info.rules, "spl2012:4");
}

TEST_F(Recording, RulesOfItsOriginStay) {
  Recorder known(channels, board, store, clock, {.info = {.robot = "14/2", .rules = "spl2025:5"}});
  known.know_rules("spl2012");
  const std::string id = *known.start("", "game");
  EXPECT_EQ(store.find(id)->info.rules, "spl2025:5");
}

TEST_F(Recording, ContainsOnlyTheNamedObjects) {
  const std::vector<std::string> names = recorder.object_names();
  for (const char* name : {"ball", "pose", "truth/world"}) EXPECT_EQ(std::ranges::count(names, name), 1) << name;
  const std::string id = *recorder.start("", "game", {"ball", "late"});
  write_ball(1);
  memory->pose.write({}, clock.now_ns());
  memory->truth.write({}, clock.now_ns());
  const auto late = tests::make_channel(clock, "/14/2/late"), later = tests::make_channel(clock, "/14/2/later");
  for (const auto& channel : {late, later}) {
    ASSERT_TRUE(channels.add(channel));
    ASSERT_TRUE(channel->write_bytes("appeared", clock.now_ns()));
  }
  ASSERT_TRUE(recorder.stop());
  EXPECT_EQ(recorder.status().messages, 2u);
  EXPECT_EQ(recorder.status().dropped, 0u);
  const Result<Session> session = store.find(id);
  ASSERT_TRUE(session);
  std::vector<std::string> topics;
  for (const StreamFile& stream : session->streams) topics.push_back(stream.topic);
  std::ranges::sort(topics);
  EXPECT_EQ(topics, (std::vector<std::string>{"/14/2/ball", "/14/2/late"}));
  // the session says what was left out by choice, in session.json and in each file
  EXPECT_EQ(session->info.only, (std::vector<std::string>{"ball", "late"}));
  std::filesystem::remove(folder.path() / id / "session.json");
  EXPECT_EQ(read_session(folder.path() / id)->info.only, (std::vector<std::string>{"ball", "late"}));

  const std::string all = *recorder.start("", "game");
  ASSERT_TRUE(recorder.stop());
  EXPECT_GT(store.find(all)->streams.size(), 4u) << "the choice is that of one session";
  EXPECT_TRUE(store.find(all)->info.only.empty());
}

TEST_F(Recording, RunsOnlyOnceAtATime) {
  const std::string id = *recorder.start("", "game");
  EXPECT_EQ(recorder.start("", "game").error(), "recording: the session " + id + " is being recorded already");
  ASSERT_TRUE(recorder.stop());
  EXPECT_EQ(recorder.stop().error(), "recording: there is none to stop");
}

TEST_F(Recording, RefusesAProfileItDoesNotKnow) {
  EXPECT_EQ(recorder.start("", "all").error(), "recording profile: expected one of game, vision, full, got 'all'");
}

TEST_F(Recording, ObjectsThatAppearLaterJoin) {
  const std::string id = *recorder.start("", "game");
  const auto late = tests::make_channel(clock, "/14/2/late");
  ASSERT_TRUE(channels.add(late));
  ASSERT_TRUE(late->write_bytes("unknown to us", clock.now_ns()));
  ASSERT_TRUE(recorder.stop());
  EXPECT_EQ(tests::read_stream(folder.path() / id / "14.2.late.mcap").at(0).bytes, "unknown to us");
}

TEST_F(Recording, TwoSessionsOfOneSecondHaveTheirOwnFolders) {
  const std::string first = *recorder.start("", "game");
  ASSERT_TRUE(recorder.stop());
  const std::string second = *recorder.start("", "game");
  ASSERT_TRUE(recorder.stop());
  EXPECT_NE(first, second);
  EXPECT_EQ(store.list().size(), 2u);
}

TEST_F(Recording, ProfileGameRecordsSmallAndFewImages) {
  const std::string id = *recorder.start("", "game");
  for (int i = 0; i < 61; ++i) {
    auto image = memory->camera_top.draft();
    image->set_encoding(pb::Image::ENCODING_YUYV);
    image->set_width(640);
    image->set_height(480);
    image->set_data(std::string(614'400, '\x80'));
    memory->camera_top.write(std::move(image), kNow + static_cast<std::uint64_t>(i) * kSecond / 30);
  }
  ASSERT_TRUE(recorder.stop());  // all eleven fit into the queue, even if the logger is slow
  const std::vector<Record> records = tests::read_stream(folder.path() / id / "14.2.camera_top.mcap");
  ASSERT_EQ(records.size(), 11u) << "two seconds at 5 Hz, both ends";
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].sequence, i + 1);
    pb::Image image;
    ASSERT_TRUE(image.ParseFromString(records[i].bytes));
    EXPECT_EQ(image.encoding(), pb::Image::ENCODING_JPEG);
    EXPECT_EQ(image.width(), 320u);
    EXPECT_EQ(image.height(), 240u);
  }
}

// a delayed thread writes its images late and close together: profile `vision` must take each image of a 30 Hz camera
TEST_F(Recording, ProfileVisionRecordsLateImagesToo) {
  const std::string id = *recorder.start("", "vision");
  std::mt19937 random(1);
  std::uint64_t last = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    auto image = memory->camera_top.draft();
    image->set_encoding(pb::Image::ENCODING_JPEG);
    image->set_data("jpeg");
    const std::uint64_t late = i % 4 == 3 ? random() % 60 * kMillisecond : 0;
    last = std::max(last + kMillisecond, kNow + i * kSecond / 30 + late);
    memory->camera_top.write(std::move(image), last);
  }
  ASSERT_TRUE(recorder.stop());
  EXPECT_EQ(tests::read_stream(folder.path() / id / "14.2.camera_top.mcap").size(), 60u);
}

// capture times are from the session's own clock, not from the system clock
TEST_F(Recording, KeepsTheOrderOfTheSessionClock) {
  const SessionClock session_clock(kNow);  // monotonic plus a fixed offset, as on the robot
  std::uint64_t last = 0;
  const std::string id = *recorder.start("", "game");
  for (int i = 0; i < 100; ++i) {
    memory->ball.write(pb::Ball(), session_clock.now_ns());
  }
  ASSERT_TRUE(recorder.stop());
  for (const Record& record : ball_records(id)) {
    EXPECT_GE(record.capture_ns, last);
    last = record.capture_ns;
  }
}

/// Runs in a process of its own: records balls, reports when `count` are written, then waits until it is killed.
[[noreturn]] void record_until_killed(const fs::path& folder, int ready, int count) {
  const SessionClock clock;
  const auto memory = std::make_shared<memory::Memory>("14/2", clock);
  memory::Channels channels;
  (void)list(memory, channels);
  LoggingBoard board;
  SessionStore store(folder, 4'000'000'000);
  Recorder recorder(channels, board, store, clock, {});
  (void)recorder.start("killed", "game");
  for (int i = 0; i < count; ++i) {
    pb::Ball ball;
    ball.set_x(static_cast<float>(i));
    memory->ball.write(ball, clock.now_ns());
  }
  // the promise: every message older than one second is on the disk; the rest is room for a busy machine
  usleep(3'000'000);
  (void)!write(ready, "x", 1);
  while (true) pause();
}

TEST(RecordingKilled, IsReadableAndItsIndexIsRebuilt) {
  const tests::TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) record_until_killed(folder.path(), ready[1], 500);
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);

  const SessionStore store(folder.path(), 4'000'000'000);
  const std::vector<Session> sessions = store.list();
  ASSERT_EQ(sessions.size(), 1u);
  EXPECT_EQ(sessions[0].state, SessionState::recovered);
  EXPECT_EQ(sessions[0].message, "the recording ended without warning; what was on the disk by then is readable");
  EXPECT_EQ(tests::read_stream(sessions[0].folder / "14.2.ball.mcap").size(), 500u);
}

TEST_F(Recording, IsRefusedIfLessThanOneMinuteFits) {
  const SmallDisk disk(folder.path(), "size=1m");
  if (!disk.mounted) GTEST_SKIP() << "needs the right to mount a small tmpfs";
  EXPECT_EQ(recorder.start("", "vision").error(),
            "recording: profile vision takes about " +
                std::to_string(std::lround(profile_named("vision")->mb_per_minute)) +
                " MB per minute; 0 minutes of it fit");
}

TEST_F(Recording, ReportsAFullDiskAndContinuesWhenThereIsRoom) {
  const SmallDisk disk(folder.path(), "size=60m");
  if (!disk.mounted) GTEST_SKIP() << "needs the right to mount a small tmpfs";
  const std::string part(4'000'000, 'x');
  std::ofstream(folder / "ballast") << part << part << part << part << part;
  const auto blobs = tests::make_channel(clock, "/14/2/blobs");
  ASSERT_TRUE(channels.add(blobs));
  const Result<std::string> session = recorder.start("", "game");
  ASSERT_TRUE(session) << session.error();

  std::mt19937 random(1);  // random bytes do not compress
  const auto write_until = [&](RecordingStatus::State state) {
    for (int i = 0; recorder.status().state != state; ++i) {
      ASSERT_LT(i, 100'000);
      std::string blob(300'000, '\0');
      for (char& c : blob) c = static_cast<char>(random());
      ASSERT_TRUE(blobs->write_bytes(blob, clock.now_ns())) << "streaming continues with a full disk";
    }
  };
  write_until(RecordingStatus::State::disk_full);
  EXPECT_NE(recorder.status().message.find("No space left on device"), std::string::npos) << recorder.status().message;
  fs::remove(folder / "ballast");
  write_until(RecordingStatus::State::recording);
  EXPECT_EQ(recorder.status().message.find("No space left"), std::string::npos);

  const RecordingStatus before = recorder.status();
  EXPECT_GT(before.dropped, 0u);
  ASSERT_TRUE(recorder.stop());
  const std::vector<Record> records = tests::read_stream(folder.path() / *session / "14.2.blobs.mcap");
  EXPECT_GT(records.back().sequence, records.size()) << "lost messages leave a gap";
}

}  // namespace
}  // namespace robot::logging
