// Files that are deleted, moved or replaced while they are recorded, and two recorders with one log folder.
#include <gtest/gtest.h>

#include <fstream>

#include "robot/core/report.h"
#include "tests/support/eventually.h"
#include "tests/support/recording.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

namespace fs = std::filesystem;
using tests::Recording;

struct Losing : Recording {
  Losing() {
    set_report_listener([this](const Report& report) { reports += report.sentence + "\n"; });
    first = *recorder.start("half", "game");
    for (int i = 0; i < 10; ++i) write_ball(static_cast<float>(i));
    EXPECT_TRUE(tests::eventually([&] { return recorder.status().messages == 10; }));
  }
  ~Losing() override { set_report_listener({}); }

  /// Ends the recording and expects that the balls that are written now are in a new session.
  void expect_a_new_session(std::uint64_t dropped) {
    const RecordingStatus status = recorder.status();
    EXPECT_EQ(status.state, RecordingStatus::State::recording);
    EXPECT_EQ(status.dropped, dropped);
    EXPECT_EQ(status.message, "session " + first +
                                  ": its files were deleted, replaced or moved while it was recorded; messages lost: " +
                                  std::to_string(dropped));
    EXPECT_NE(reports.find(status.message + "\n"), std::string::npos);
    write_ball(99);
    ASSERT_TRUE(recorder.stop());
    EXPECT_EQ(store.find(status.session)->info.name, "half");
    EXPECT_EQ(store.find(status.session)->state, SessionState::complete);
    const std::vector<Record> records = ball_records(status.session);
    EXPECT_EQ(records.back().sequence, 11u);
    EXPECT_EQ(records.size(), 2u) << "begins with the newest version";
  }

  std::string reports, first;
};

TEST_F(Losing, AWholeSessionIsLeftAlone) {
  recorder.tend();
  recorder.tend();
  EXPECT_EQ(recorder.status().session, first);
  EXPECT_EQ(recorder.status().dropped, 0u);
  EXPECT_EQ(recorder.status().message, "");
}

TEST_F(Losing, ADeletedSessionIsCountedAsDroppedAndBegunAnew) {
  fs::remove_all(folder / first);
  recorder.tend();
  EXPECT_EQ(reports.find("cannot make"), std::string::npos) << "one sentence, not one for each stream";
  expect_a_new_session(10);
}

TEST_F(Losing, ADeletedLogFolderIsMadeAnew) {
  fs::remove_all(folder.path());
  recorder.tend();
  expect_a_new_session(10);
}

TEST_F(Losing, AMovedSessionLosesNothing) {
  fs::rename(folder / first, folder / "moved");
  recorder.tend();
  expect_a_new_session(0);
  EXPECT_EQ(ball_records("moved").size(), 10u);
}

// its session.json once stayed as at the beginning, so that it looked like a session whose writer had died
TEST_F(Losing, AMovedSessionGetsItsEndAndItsAccount) {
  fs::rename(folder / first, folder / "moved");
  recorder.tend();
  const Session moved = *read_session(folder / "moved");
  EXPECT_EQ(moved.state, SessionState::complete);
  EXPECT_EQ(moved.info.account, (SessionAccount{.messages = 10, .dropped = 0}));
  EXPECT_EQ(moved.message, "");
  EXPECT_FALSE(fs::exists(folder / "moved" / kLockFile));
}

TEST_F(Losing, TheAccountIsShownAfterTheEnd) {
  recorder.tend();
  fs::remove(folder / first / "14.2.ball.mcap");
  ASSERT_TRUE(recorder.stop());
  const RecordingStatus last = recorder.status();
  EXPECT_EQ(last.state, RecordingStatus::State::off);
  EXPECT_EQ(last.session, first);
  EXPECT_EQ(last.messages, 0u);
  EXPECT_EQ(last.dropped, 10u);
  EXPECT_TRUE(last.message.ends_with("messages lost: 10")) << last.message;
  EXPECT_EQ(store.find(first)->info.account, (SessionAccount{.messages = 0, .dropped = 10}));
  EXPECT_EQ(store.find(first)->message, "messages lost while it was recorded: 10");
  ASSERT_TRUE(recorder.start("next", "game"));
  EXPECT_EQ(recorder.status().dropped, 0u) << "a new account";
}

// a message counts as recorded when the death of the process cannot lose it any more
TEST_F(Losing, MessagesOnTheWayToAFileAreNoRecordedMessages) {
  write_ball(11);
  ASSERT_TRUE(tests::eventually([&] {
    const RecordingStatus status = recorder.status();
    EXPECT_LE(status.messages, ball_records(first).size());
    return status.messages == 11 && status.waiting == 0;
  }));
}

TEST_F(Losing, AReplacedFolderIsNoticed) {
  fs::rename(folder / first, folder / "moved");
  fs::create_directory(folder / first);
  fs::remove_all(folder / "moved");
  recorder.tend();
  EXPECT_TRUE(fs::is_empty(folder / first)) << "nothing is written into another folder";
  expect_a_new_session(10);
}

TEST_F(Losing, ADeletedFileIsNoticed) {
  fs::remove(folder / first / "14.2.ball.mcap");
  recorder.tend();
  EXPECT_NE(recorder.status().session, first);
  EXPECT_EQ(store.find(first)->state, SessionState::complete) << "the other files are closed";
  expect_a_new_session(10);
}

TEST_F(Losing, AReplacedFileIsNoticed) {
  recorder.tend();
  const fs::path file = folder / first / "14.2.ball.mcap";
  fs::copy_file(file, folder / "copy");
  fs::rename(folder / "copy", file);
  recorder.tend();
  expect_a_new_session(10);
}

TEST_F(Losing, ALossIsNamedAtTheEndToo) {
  fs::remove_all(folder / first);
  ASSERT_TRUE(recorder.stop());
  EXPECT_NE(reports.find("session " + first +
                         ": its files were deleted, replaced or moved while it was recorded; "
                         "messages lost: 10\n"),
            std::string::npos)
      << reports;
}

TEST_F(Losing, AnotherRuntimeLeavesTheLiveSessionAlone) {
  SessionStore other(folder.path(), 0);
  EXPECT_EQ(other.list().at(0).state, SessionState::recording);
  EXPECT_TRUE(other.make_room(0, 0).empty());
  EXPECT_FALSE(other.remove(first));
  ASSERT_TRUE(recorder.stop());
  EXPECT_EQ(other.list().at(0).state, SessionState::complete);
}

// topics that differ only in characters that do not suit a file name once shared a file, and one was not recorded
TEST_F(Losing, EveryTopicHasAFileOfItsOwn) {
  std::vector<std::string> topics{"/debug/a/b", "/debug/a.b", "/ü", "/ö", "", "/A", "/a", "//", std::string(1000, 'x')};
  for (const std::string& topic : topics) {
    const auto channel = tests::make_channel(clock, topic);
    ASSERT_TRUE(channels.add(channel)) << topic;
    ASSERT_TRUE(channel->write_bytes("of " + topic, clock.now_ns()));
  }
  ASSERT_TRUE(recorder.stop());
  const Session session = *store.find(first);
  EXPECT_EQ(session.state, SessionState::complete) << session.message;
  for (const std::string& topic : topics) {
    const auto stream = std::ranges::find(session.streams, topic, &StreamFile::topic);
    ASSERT_NE(stream, session.streams.end()) << topic;
    EXPECT_EQ(tests::read_stream(session.folder / stream->file).at(0).bytes, "of " + topic);
  }
}

}  // namespace
}  // namespace robot::logging
