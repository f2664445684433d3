#include "robot/logging/sessions/session.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <optional>

#include "robot/core/files.h"
#include "robot/logging/mcap/format.h"
#include "robot/logging/sessions/checksums.h"
#include "robot/logging/sessions/downloads.h"
#include "robot/logging/sessions/owned_folder.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/logging/streams/file_provider.h"
#include "tests/support/mcap_text.h"
#include "tests/support/temporary_folder.h"

namespace robot::logging {
namespace {

SessionInfo example() {
  return {.name = "half 1",
          .about = "a camera 1.2 m above the ground",
          .robot = "14/2",
          .team = 14,
          .player = 2,
          .build = "0123abcd",
          .profile = "game",
          .rules = "spl2025:5",
          .only = {"ball", "truth/world"},
          .start_ns = 1'700'000'000'123'456'789,
          .behind_ns = -180'000'000'001,
          .number = 7,
          .boot = "0b7e",
          .kept = true,
          .complete = true};
}

TEST(SessionInfo, RoundTripsThroughItsJson) {
  EXPECT_EQ(*parse_session_info(to_json(example())), example());
  SessionInfo ended = example();
  ended.account = {.messages = std::uint64_t{1} << 60, .dropped = 3};
  EXPECT_EQ(*parse_session_info(to_json(ended)), ended);
}

TEST(SessionInfo, SurvivesEveryTruncation) {
  const std::string text = to_json(example());
  const std::size_t last = text.rfind('}');
  for (std::size_t size = 0; size <= last; ++size) EXPECT_FALSE(parse_session_info(text.substr(0, size)));
}

TEST(SessionInfo, NamesTheWrongValue) {
  EXPECT_EQ(parse_session_info("[]").error(), "session.json: expected a JSON object");
  EXPECT_EQ(parse_session_info(R"({"name": 3})").error(), "session.json: 'name' is missing or of the wrong type");
  EXPECT_EQ(parse_session_info(R"({"name": "", "robot": "", "team": 1, "player": 2, "build": "", "profile": "",
                                   "start_ns": "1", "only": ["ball", 3], "kept": true, "complete": true})")
                .error(),
            "session.json: 'only' is missing or of the wrong type");
  std::string text = to_json(example());
  text.replace(text.find(": 14\n"), 4, ": \"14\"");
  EXPECT_EQ(parse_session_info(text).error(), "session.json: 'team' is missing or of the wrong type");
}

TEST(SessionInfo, IsValidJsonAlsoIfTheNameIsNotUtf8) {
  SessionInfo info = example();
  info.name = "\xff\xfe";
  EXPECT_TRUE(parse_session_info(to_json(info)));
}

TEST(SessionInfo, AcceptsAWholeNumberWithAPointAndSessionsOfEarlierVersions) {
  std::string text = to_json(example());
  text.replace(text.find(": 14\n"), 4, ": 14.0");
  EXPECT_EQ(*parse_session_info(text), example());
  for (const std::string key :
       {"\"about\": \"a camera 1.2 m above the ground\",", "\"number\": \"7\",", "\"boot\": \"0b7e\","})
    text.erase(text.find(key), key.size());
  ASSERT_TRUE(parse_session_info(text));
  EXPECT_EQ(parse_session_info(text)->number, 0u);
  SessionInfo all = example();
  all.only.clear();
  EXPECT_EQ(to_json(all).find("only"), std::string::npos);
  EXPECT_EQ(parse_session_info(to_json(all))->only, all.only);
}

TEST(SessionInfo, ReadableFactsAreTakenAndOthersStay) {
  SessionInfo info{.name = "before", .team = 5};
  EXPECT_EQ(take_session_info(R"({"name": 3, "team": 14, "kept": true})", info).error(),
            "session.json: 'name' is missing or of the wrong type");
  EXPECT_EQ(info.name, "before");
  EXPECT_EQ(info.team, 14);
  EXPECT_TRUE(info.kept);
}

TEST(SessionInfo, RoundTripsThroughTheMetadataOfAFile) {
  std::vector<mcap::Metadata> metadata;
  EXPECT_FALSE(session_info_in(metadata));
  for (const auto& [name, entries] : metadata_of(example()))
    metadata.push_back({.name = name, .entries = {entries.begin(), entries.end()}});
  SessionInfo expected = example();
  expected.kept = expected.complete = false;  // they change later, so a file does not hold them
  EXPECT_EQ(*session_info_in(metadata), expected);
}

TEST(SessionNames, ThatCannotBeUsedAreRefused) {
  EXPECT_TRUE(check_session_name(""));
  EXPECT_TRUE(check_session_name("Fr\u00fchst\u00fcck / A"));
  EXPECT_EQ(check_session_name(std::string(5'000, 'x')).error(), "session name: expected at most 100 bytes, got 5000");
  for (const char* name : {"a\nb", "\x1b[2J", "\xff\xfe"})
    EXPECT_TRUE(check_session_name(name).error().starts_with(
        "session name: expected UTF-8 text without control characters, got '"));
}

TEST(SessionNames, HoldOnlySafeCharacters) {
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

// a message at time 0 once stretched the viewer's time line from 1970 to today
TEST_F(WrittenSession, StrayTimesAreLeftOutOfItsTimeLineAndNamed) {
  constexpr std::uint64_t kStart = 1'700'000'000'000'000'000;
  auto writer = SessionWriter::create(folder / "strays", example());
  for (std::uint64_t i = 0; i < 5; ++i) EXPECT_TRUE((*writer)->write({.topic = "/14/2/a"}, kStart + i, "a"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/a"}, 0, "stray"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/a"}, std::uint64_t{1} << 63, "stray"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/b"}, 7, "all of this stream is stray"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/c"}, kStart + 100, "c"));
  EXPECT_TRUE((*writer)->close());
  const Session session = *read_session(folder / "strays");
  EXPECT_EQ(session.start_ns, kStart);
  EXPECT_EQ(session.end_ns, kStart + 100);
  EXPECT_EQ(session.state, SessionState::complete);
  EXPECT_EQ(session.message,
            "2 messages before 2023-11-14 22:13:20 UTC and 1 message after 2023-11-14 22:13:20 UTC left out of the "
            "strip, because more than 30 days lie between");
}

// the message `game` of two minutes ago once stretched the strip of a recording of 4 s to 2:07
TEST_F(WrittenSession, RetainedValuesDoNotStretchItsTimeLine) {
  constexpr std::uint64_t kSecondNs = 1'000'000'000;
  const std::uint64_t start_ns = example().start_ns;
  auto writer = SessionWriter::create(folder / "retained", example());
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/game"}, start_ns - 123 * kSecondNs, "retained"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/game"}, start_ns + 2 * kSecondNs, "changed"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/battery"}, start_ns - 50 * kSecondNs, "retained"));
  for (std::uint64_t i = 0; i < 5; ++i)
    EXPECT_TRUE((*writer)->write({.topic = "/14/2/ball"}, start_ns - 5 + i * kSecondNs, "ball"));
  EXPECT_TRUE((*writer)->close());
  const Session session = *read_session(folder / "retained");
  EXPECT_EQ(session.start_ns, start_ns - 5);
  EXPECT_EQ(session.end_ns, start_ns - 5 + 4 * kSecondNs);
  EXPECT_EQ(session.message, "");
  Downloads downloads;
  std::ofstream(folder / "one.mcap", std::ios::binary) << tests::all_bytes(**downloads.open(session, {}, {}));
  EXPECT_EQ(read_recording(folder / "one.mcap")->start_ns, session.start_ns) << "the same as one file";
}

// a half was once told to begin three minutes early: a value from before it was written twice
TEST_F(WrittenSession, ARepeatedRetainedValueDoesNotStretchItsTimeLine) {
  const std::uint64_t start_ns = example().start_ns;
  auto writer = SessionWriter::create(folder / "repeated", example());
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE((*writer)->write({.topic = "/14/2/game"}, start_ns - 180 * kSecond, "the same state again"));
  for (std::uint64_t i = 0; i < 3; ++i)
    EXPECT_TRUE((*writer)->write({.topic = "/14/2/pose"}, start_ns - (i < 2 ? 90 * kSecond : 0), "written late"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/ball"}, start_ns + kSecond, "ball"));
  EXPECT_TRUE((*writer)->close());
  EXPECT_EQ(read_session(folder / "repeated")->start_ns, start_ns);
  EXPECT_EQ(read_session(folder / "repeated")->end_ns, start_ns + kSecond);
}

TEST_F(WrittenSession, WithNothingButRetainedValuesItBeginsWithItsRecorderAndHasNoLength) {
  const std::uint64_t start_ns = example().start_ns;
  auto writer = SessionWriter::create(folder / "still", example());
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/game"}, start_ns - 180 * kSecond, "retained"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/strategy"}, start_ns - 60 * kSecond, "retained"));
  EXPECT_TRUE((*writer)->close());
  EXPECT_EQ(read_session(folder / "still")->start_ns, start_ns);
  EXPECT_EQ(read_session(folder / "still")->end_ns, start_ns);
}

TEST_F(WrittenSession, DataOfAnotherClockStayInItsTimeLine) {
  const std::uint64_t start_ns = example().start_ns, away_ns = 10'000'000'000;
  auto writer = SessionWriter::create(folder / "behind", example());
  for (std::uint64_t i = 0; i < 5; ++i)
    EXPECT_TRUE((*writer)->write({.topic = "/14/2/a"}, start_ns - away_ns + i * away_ns, "a"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/b"}, start_ns - 2 * away_ns, "b"));
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/b"}, start_ns - away_ns / 2, "b"));
  EXPECT_TRUE((*writer)->close());
  EXPECT_EQ(read_session(folder / "behind")->start_ns, start_ns - away_ns / 2) << "two messages are no retained value";
}

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
  std::optional owner = *OwnedFolder::own(folder / "s");
  EXPECT_EQ(store.remove("s").error(), "session s: it is being recorded, and cannot be deleted yet");
  owner.reset();
  EXPECT_FALSE(store.remove("../s"));
  EXPECT_TRUE(store.remove("s"));
  EXPECT_FALSE(std::filesystem::exists(folder / "s"));
  EXPECT_EQ(store.remove("s").error(), "session: there is none called 's'");
}

// a shell completes the name of a folder with a slash
TEST_F(WrittenSession, HasTheSameNameWithASlashAtTheEnd) {
  for (const char* path : {"s/", "s//", "s/.", "x/../s/"}) {
    const Result<Session> session = open_session(folder / path);
    ASSERT_TRUE(session) << session.error();
    EXPECT_EQ(session->id(), "s");
    EXPECT_EQ(session->folder, folder / "s");
  }
}

TEST(PlainPath, EndsWithTheNameOfTheFolder) {
  EXPECT_EQ(plain_path("logs/s/"), "logs/s");
  EXPECT_EQ(plain_path("logs/./s"), "logs/s");
  EXPECT_EQ(plain_path("/"), "/");
  EXPECT_EQ(plain_path("."), std::filesystem::current_path());
  EXPECT_EQ(plain_path(".."), std::filesystem::current_path().parent_path());
}

TEST(LogFolder, ContainsTheSessionAlsoWithASlashAtTheEnd) {
  for (const char* path : {"/a/logs/s", "/a/logs/s/", "/a/logs/s/.", "/a/logs/game.mcap"})
    EXPECT_EQ(log_folder_of(path), "/a/logs") << path;
  EXPECT_EQ(log_folder_of("s/"), std::filesystem::current_path());
  EXPECT_EQ(log_folder_of("."), std::filesystem::current_path().parent_path());
}

TEST_F(WrittenSession, PipesLinksAndFoldersInItsFolderAreSkipped) {
  ASSERT_EQ(::mkfifo((folder / "s/pipe.mcap").c_str(), 0600), 0);
  std::filesystem::create_symlink(folder / "s/14.2.a.mcap", folder / "s/link.mcap");
  std::filesystem::create_directory(folder / "s/folder.mcap");
  const Result<Session> session = read_session(folder / "s");
  ASSERT_TRUE(session) << session.error();
  EXPECT_EQ(session->state, SessionState::complete);
  EXPECT_EQ(session->streams.size(), 2u);
  EXPECT_EQ(Checksums().of_folder(folder / "s")->size(), 3u);
}

TEST_F(WrittenSession, ItsDescriptionIsNeitherAPipeNorALink) {
  std::filesystem::remove(folder / "s/session.json");
  ASSERT_EQ(::mkfifo((folder / "s/session.json").c_str(), 0600), 0);
  const Result<Session> session = read_session(folder / "s");
  ASSERT_TRUE(session) << session.error();
  EXPECT_EQ(session->rebuilt, "cannot read " + (folder / "s/session.json").string() + ": expected a file");
  EXPECT_EQ(session->info.robot, "14/2");
}

TEST_F(WrittenSession, IsNotOverwritten) {
  EXPECT_EQ(SessionWriter::create(folder / "s", example()).error(),
            "session " + (folder / "s").string() + ": there is one already");
}

TEST_F(WrittenSession, IsOwnedUntilItIsClosed) {
  EXPECT_FALSE(is_owned(folder / "s"));
  auto writer = SessionWriter::create(folder / "new/", example());
  ASSERT_TRUE(writer) << writer.error();
  EXPECT_EQ((*writer)->folder(), folder / "new");
  EXPECT_TRUE(is_owned(folder / "new"));
  ASSERT_TRUE((*writer)->close());
  EXPECT_FALSE(is_owned(folder / "new"));
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
  EXPECT_EQ(recording->info.rules, "spl2025:5");
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
