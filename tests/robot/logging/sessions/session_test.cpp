#include "robot/logging/sessions/session.h"

#include <gtest/gtest.h>

#include <fstream>

#include "robot/core/files.h"
#include "robot/logging/mcap/format.h"
#include "robot/logging/sessions/downloads.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/logging/streams/file_provider.h"
#include "tests/support/mcap_text.h"
#include "tests/support/temporary_folder.h"

namespace robot::logging {
namespace {

SessionInfo example() {
  return {.name = "half 1",
          .robot = "14/2",
          .team = 14,
          .player = 2,
          .build = "0123abcd",
          .profile = "game",
          .start_ns = 1'700'000'000'123'456'789,
          .kept = true,
          .complete = true};
}

TEST(SessionInfo, RoundTripsThroughItsJson) { EXPECT_EQ(*parse_session_info(to_json(example())), example()); }

TEST(SessionInfo, SurvivesEveryTruncation) {
  const std::string text = to_json(example());
  const std::size_t last = text.rfind('}');
  for (std::size_t size = 0; size <= last; ++size) EXPECT_FALSE(parse_session_info(text.substr(0, size)));
}

TEST(SessionInfo, NamesTheWrongValue) {
  EXPECT_EQ(parse_session_info("[]").error(), "session.json: expected a JSON object");
  EXPECT_EQ(parse_session_info(R"({"name": 3})").error(), "session.json: 'name' is missing or of the wrong type");
  std::string text = to_json(example());
  text.replace(text.find(": 14\n"), 4, ": \"14\"");
  EXPECT_EQ(parse_session_info(text).error(), "session.json: 'team' is missing or of the wrong type");
}

TEST(SessionInfo, IsValidJsonAlsoIfTheNameIsNotUtf8) {
  SessionInfo info = example();
  info.name = "\xff\xfe";
  EXPECT_TRUE(parse_session_info(to_json(info)));
}

TEST(SessionNames, HoldOnlySafeCharacters) {
  EXPECT_EQ(stream_file_name("/14/2/camera_top"), "14.2.camera_top.mcap");
  EXPECT_EQ(stream_file_name("/../../etc/passwd"), "......etc.passwd.mcap");
  EXPECT_EQ(stream_file_name("/a b\n\"<>"), "a_b____.mcap");
  EXPECT_EQ(session_folder_name(1'700'000'000'000'000'000, "", "game"), "2023-11-14_22-13-20_game");
  EXPECT_EQ(session_folder_name(1'700'000'000'000'000'000, "../x y", "game"), "2023-11-14_22-13-20_.._x_y");
}

struct WrittenSession : ::testing::Test {
  WrittenSession() {
    auto writer = SessionWriter::create(folder / "s", example());
    for (std::uint64_t i = 0; i < 10; ++i) {
      EXPECT_TRUE((*writer)->write({.topic = "/14/2/a"}, 100 + i, "a"));
      if (i >= 5) continue;
      EXPECT_TRUE((*writer)->write({.topic = "/14/2/b"}, 50 + i, "bb"));
    }
    EXPECT_TRUE((*writer)->close());
  }
  const tests::TemporaryFolder folder;
};

TEST_F(WrittenSession, IsReadWithItsStreamsAndTimes) {
  const Result<Session> session = read_session(folder / "s");
  ASSERT_TRUE(session) << session.error();
  EXPECT_EQ(session->state, SessionState::complete);
  EXPECT_EQ(session->info, example());
  EXPECT_EQ(session->start_ns, 50u);
  EXPECT_EQ(session->end_ns, 109u);
  ASSERT_EQ(session->streams.size(), 2u);
  EXPECT_EQ(session->streams[0].topic, "/14/2/a");
  EXPECT_EQ(session->streams[0].messages, 10u);
  EXPECT_EQ(session->streams[1].messages, 5u);
}

TEST_F(WrittenSession, IsDeletedUnlessItIsKeptOrBeingWritten) {
  SessionStore store(folder.path(), 1'000'000);
  EXPECT_EQ(store.remove("s").error(), "session s: it is kept, and cannot be deleted");
  ASSERT_TRUE(store.keep("s", false));
  store.set_recording("s");
  EXPECT_EQ(store.remove("s").error(), "session s: it is being recorded, and cannot be deleted yet");
  store.set_recording("");
  EXPECT_FALSE(store.remove("../s"));
  EXPECT_TRUE(store.remove("s"));
  EXPECT_FALSE(std::filesystem::exists(folder / "s"));
  EXPECT_EQ(store.remove("s").error(), "session: there is none called 's'");
}

TEST_F(WrittenSession, IsNotOverwritten) {
  EXPECT_EQ(SessionWriter::create(folder / "s", example()).error(),
            "session " + (folder / "s").string() + ": there is one already");
}

TEST_F(WrittenSession, OpensItsReadablePartAndNamesTheDamage) {
  std::ofstream(folder / "s/14.2.a.mcap", std::ios::trunc) << "no recording at all";
  const Result<Session> session = read_session(folder / "s");
  ASSERT_TRUE(session);
  EXPECT_EQ(session->state, SessionState::damaged);
  EXPECT_EQ(session->message, session->streams[0].damage);
  EXPECT_EQ(session->message.rfind("14.2.a.mcap: "), 0u) << "the file is named, once: " << session->message;
  EXPECT_EQ(session->streams[1].messages, 5u);
}

TEST_F(WrittenSession, IsOneDownloadAndSoIsEachStream) {
  Downloads downloads;
  const Session session = *read_session(folder / "s");
  const auto whole = downloads.open(session, {}, {});
  ASSERT_TRUE(whole) << whole.error();
  EXPECT_EQ((*whole)->statistics().messages, 15u);
  EXPECT_EQ((*downloads.open(session, "14.2.b.mcap", {}))->statistics().messages, 5u);
  EXPECT_EQ(downloads.open(session, "x.mcap", {}).error(), "session s: there is no stream 'x.mcap'");
}

TEST_F(WrittenSession, IsAssembledOnceForManyRanges) {
  Downloads downloads;
  const Session session = *read_session(folder / "s");
  EXPECT_EQ(*downloads.open(session, {}, {}), *downloads.open(session, {}, {}));
  EXPECT_NE(*downloads.open(session, {}, {}), *downloads.open(session, {}, {.from_ns = 105}));
}

TEST_F(WrittenSession, AsOneFileIsTheSameSession) {
  const Session session = *read_session(folder / "s");
  Downloads downloads;
  std::ofstream(folder / "whole.mcap", std::ios::binary) << tests::all_bytes(**downloads.open(session, {}, {}));

  const auto recording = read_recording(folder / "whole.mcap");
  ASSERT_TRUE(recording) << recording.error();
  EXPECT_EQ(recording->info.robot, session.info.robot);
  EXPECT_EQ(recording->info.team, session.info.team);
  EXPECT_EQ(recording->info.player, session.info.player);
  EXPECT_EQ(recording->start_ns, session.start_ns);
  EXPECT_EQ(recording->end_ns, session.end_ns);
  ASSERT_EQ(recording->streams.size(), session.streams.size());

  // each stream has the same messages as in its own file
  for (const StreamFile& stream : session.streams) {
    FileInProvider own(folder / "s" / stream.file), shared(folder / "whole.mcap", stream.topic);
    EXPECT_EQ(own.open().value(), shared.open().value());
    std::uint64_t messages = 0;
    for (;; ++messages) {
      const auto expected = own.read(), read = shared.read();
      ASSERT_TRUE(expected && read);
      ASSERT_EQ(*expected, *read) << stream.topic;
      if (!*expected) break;
    }
    EXPECT_EQ(messages, stream.messages);
  }
}

TEST_F(WrittenSession, NamesATopicThatAFileDoesNotHold) {
  const Session session = *read_session(folder / "s");
  const auto file = folder / "s" / session.streams.front().file;
  FileInProvider in(file, "/14/2/none");
  EXPECT_EQ(in.open().error(), file.string() + ": expected a channel /14/2/none, there is none");
}

}  // namespace
}  // namespace robot::logging
