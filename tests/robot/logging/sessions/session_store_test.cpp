#include "robot/logging/sessions/session_store.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <optional>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/report.h"
#include "robot/logging/sessions/owned_folder.h"
#include "robot/logging/sessions/session_counter.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/times.h"

namespace robot::logging {
namespace {

using tests::kHour, tests::kNow;

namespace fs = std::filesystem;

/// Sets the time of all files below `folder` to long ago, so that they look as old as the session is.
void age(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    fs::last_write_time(entry.path(), fs::file_time_type::clock::now() - std::chrono::hours(24 * 1000));
}

struct OldSessions : ::testing::Test {
  /// Makes a complete session of about `bytes` that ended `age_hours` ago.
  std::string make(std::uint64_t age_hours, std::size_t bytes, SessionInfo info = {}) {
    info.start_ns = kNow - age_hours * kHour;
    return make_at(session_folder_name(info.start_ns, "old", "game"), bytes, info);
  }
  std::string make_at(const std::string& id, std::size_t bytes, SessionInfo info) {
    info.complete = true;
    fs::create_directories(folder / id);
    std::ofstream(folder / id / "session.json") << to_json(info);
    std::ofstream(folder / id / "ballast") << std::string(bytes, 'x');
    age(folder / id);
    return id;
  }
  bool there(const std::string& id) { return fs::exists(folder / id); }

  const tests::TemporaryFolder folder;
};

using Ids = std::vector<std::string>;

// the index of a large recording without one takes long; a list once waited for it
TEST_F(OldSessions, AListThatMustNotWaitHasEachSessionAtOnceAndItsStreamsSoon) {
  auto writer = SessionWriter::create(folder / "new", {.name = "half", .robot = "14/2", .start_ns = kNow});
  EXPECT_TRUE((*writer)->write({.topic = "/14/2/a"}, kNow, "a"));
  ASSERT_TRUE((*writer)->close());
  make(48, 10);
  fs::create_directory(folder / "no session");
  // the other thread is done before, between or after the questions of the list
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Session newest = SessionStore(folder.path(), 0).list_within(i * 1000).at(0);
    EXPECT_EQ(newest.streams.size(), newest.read ? 1u : 0u);
  }
  const SessionStore store(folder.path(), 0);
  const std::vector<Session> at_once = store.list_within(0);
  ASSERT_EQ(at_once.size(), 2u);
  EXPECT_EQ(at_once[0].id(), "new");
  EXPECT_EQ(at_once[0].info.name, "half");
  EXPECT_EQ(at_once[0].state, SessionState::complete);
  ASSERT_TRUE(tests::eventually([&] { return store.list_within(0)[0].read; }));
  EXPECT_EQ(store.list_within(0)[0].streams.size(), 1u);
  EXPECT_EQ(store.list_within(60 * kSecond)[0].message, "");
  // as it was read last, while a change is read
  ASSERT_TRUE(store_file(folder / "new/session.json",  // at once: the other thread would mend half a file
                         to_json({.name = "renamed", .robot = "14/2", .start_ns = kNow, .complete = true})));
  EXPECT_EQ(store.list_within(0)[0].streams.size(), 1u);
  EXPECT_EQ(store.list_within(60 * kSecond)[0].info.name, "renamed");
}

TEST_F(OldSessions, TheOldestAreDeletedFirstAndNeverAYoungOrAKeptOne) {
  const std::string kept = make(96, 1'000'000, {.kept = true});
  const std::string oldest = make(72, 1'000'000);
  const std::string older = make(48, 1'000'000);
  const std::string young = make(23, 1'000'000);
  SessionStore small(folder.path(), 3'500'000);
  EXPECT_EQ(small.make_room(0, kNow), Ids{oldest});
  EXPECT_EQ(small.make_room(3'000'000, kNow), Ids{older});
  EXPECT_TRUE(there(kept));
  EXPECT_TRUE(there(young));
}

// the clock of a robot without a network may say 1970
TEST_F(OldSessions, AreDeletedInTheOrderOfTheirNumbersWithAnyClock) {
  make_at("1970_b", 1'000'000, {.start_ns = 60 * kSecond, .number = 2, .boot = "before"});
  make_at("2023_a", 1'000'000, {.start_ns = kNow - 900 * kHour, .number = 1, .boot = "before"});
  make_at("1970_c", 1'000'000, {.start_ns = 30 * kSecond, .number = 3, .boot = boot_id()});
  SessionStore small(folder.path(), 2'500'000);
  EXPECT_EQ(small.make_room(0, kNow), Ids{"2023_a"});
  EXPECT_EQ(small.make_room(2'000'000, kNow), Ids{"1970_b"});
  EXPECT_EQ(small.make_room(2'500'000, kNow), Ids{}) << "a session of this boot stays";
  EXPECT_EQ(small.list().at(0).id(), "1970_c");
}

TEST_F(OldSessions, AreDeletableWithAClockIn1970) {
  const std::string id = make(40 * 24, 1'000);
  SessionStore small(folder.path(), 0);
  EXPECT_GT(small.deletable_bytes(60 * kSecond), 1'000u);
  EXPECT_EQ(small.make_room(0, 60 * kSecond), Ids{id});
}

TEST_F(OldSessions, APersonMayKeepAndRelease) {
  const std::string id = make(72, 1'000);
  SessionStore small(folder.path(), 0);
  ASSERT_TRUE(small.keep(id, true));
  age(folder / id);
  EXPECT_TRUE(small.make_room(0, kNow).empty());
  ASSERT_TRUE(small.keep(id, false));
  age(folder / id);
  EXPECT_EQ(small.make_room(0, kNow), Ids{id});
}

// two runtimes with one log folder: the second once deleted the session that the first recorded
TEST_F(OldSessions, ASessionThatAnotherStoreOwnsIsLiveAndStays) {
  const std::string id = make(72, 1'000);
  std::optional owner = *OwnedFolder::own(folder / id);
  SessionStore small(folder.path(), 0);
  EXPECT_EQ(small.list().at(0).state, SessionState::recording);
  EXPECT_EQ(small.deletable_bytes(kNow), 0u);
  EXPECT_TRUE(small.make_room(0, kNow).empty());
  EXPECT_EQ(small.remove(id).error(), "session " + id + ": it is being recorded, and cannot be deleted yet");
  owner.reset();
  EXPECT_EQ(small.list().at(0).state, SessionState::complete);
  EXPECT_EQ(small.make_room(0, kNow), Ids{id});
}

TEST_F(OldSessions, WithAFolderInThemAreNotDeleted) {
  const std::string id = make(72, 1'000);
  fs::create_directory(folder / id / "mine");
  SessionStore small(folder.path(), 0);
  EXPECT_TRUE(small.make_room(0, kNow).empty());
  EXPECT_EQ(small.remove(id).error(),
            "session " + id + ": cannot delete it: it contains the folder 'mine', which no recording makes");
  EXPECT_TRUE(there(id));
}

TEST_F(OldSessions, AreDeletedWithTheirPipesAndLinksButNotTheTargets) {
  const std::string id = make(72, 1'000);
  std::ofstream(folder / "target") << "x";
  fs::create_symlink(folder / "target", folder / id / "link");
  ASSERT_EQ(::mkfifo((folder / id / "pipe").c_str(), 0600), 0);
  SessionStore small(folder.path(), 0);
  EXPECT_EQ(small.make_room(0, kNow), Ids{id});
  EXPECT_TRUE(there("target"));
  EXPECT_FALSE(there(id));
}

TEST_F(OldSessions, ALinkToASessionElsewhereIsNotFollowed) {
  const tests::TemporaryFolder elsewhere;
  fs::create_directory_symlink(folder / make(72, 1'000), elsewhere / "link");
  SessionStore small(elsewhere.path(), 0);
  EXPECT_TRUE(small.list().empty());
  EXPECT_EQ(small.find("link").error(), "session: there is none called 'link'");
  EXPECT_TRUE(small.make_room(0, kNow).empty());
}

TEST_F(OldSessions, NamesThatContainAPathAreRefused) {
  make(1, 10);
  const SessionStore store(folder.path(), 0);
  for (const char* id : {"", ".", "..", "../etc", "/etc", "a/b", ".hidden"})
    EXPECT_EQ(store.find(id).error(), "session: expected the name of a session, got '" + std::string(id) + "'");
  EXPECT_EQ(store.find("missing").error(), "session: there is none called 'missing'");
  EXPECT_FALSE(store.find(std::string(5'000, 'x')));
}

// such a folder once ended the process
TEST(UnusableLogFolder, HasNoSessions) {
  const tests::TemporaryFolder folder;
  fs::create_symlink("loop", folder / "loop");
  std::ofstream(folder / "file") << "x";
  for (const fs::path& path : {folder / "loop", folder / "file", folder / "none", folder / std::string(5'000, 'x')}) {
    SessionStore store(path, 1'000);
    EXPECT_TRUE(store.list().empty());
    EXPECT_EQ(store.size_bytes(), 0u);
    EXPECT_EQ(store.deletable_bytes(kNow), 0u);
    EXPECT_TRUE(store.make_room(5'000, kNow).empty());
    EXPECT_FALSE(store.find("one"));
    EXPECT_FALSE(store.keep("one", true));
    EXPECT_FALSE(store.remove("one"));
    (void)store.disk_free_bytes();
  }
}

struct Described : ::testing::Test {
  Described() {
    auto writer = SessionWriter::create(folder / "s", info);
    EXPECT_TRUE((*writer)->write({.topic = "/14/2/a"}, 100, "a"));
    EXPECT_TRUE((*writer)->write({.topic = "/14/2/b"}, 200, "b"));
    EXPECT_TRUE((*writer)->close());
    set_report_listener([this](const Report& report) { reports.push_back(report.sentence); });
  }
  ~Described() override { set_report_listener({}); }

  const tests::TemporaryFolder folder;
  const fs::path json = folder / "s/session.json";
  const SessionInfo info{.name = "half 1",
                         .robot = "14/2",
                         .team = 14,
                         .player = 2,
                         .build = "abc",
                         .profile = "game",
                         .start_ns = kNow,
                         .number = 5,
                         .boot = "before"};
  std::vector<std::string> reports;
};

/// Returns many damaged forms of a description.
std::vector<std::string> damaged(const std::string& good) {
  std::vector<std::string> all{"", std::string(good.size(), '\0'), "[]", "null", std::string(2 << 20, ' ')};
  for (std::size_t size = 1; size < good.rfind('}'); size += 7) all.push_back(good.substr(0, size));
  for (const char* key : {"name", "robot", "team", "player", "build", "profile", "start_ns", "kept", "complete"}) {
    all.push_back(good);
    all.back().replace(all.back().find(key), 1, "X");
  }
  all.push_back(good);
  all.back().replace(all.back().find("\"team\": 14"), 10, "\"team\": \"?\"");
  return all;
}

TEST_F(Described, ADamagedDescriptionIsWrittenAnewFromTheRecordings) {
  SessionInfo expected = info;
  expected.complete = true;
  for (const std::string& text : damaged(*read_file(json, 1 << 20))) {
    std::ofstream(json, std::ios::trunc) << text;
    reports.clear();
    SessionStore store(folder.path(), 1'000'000'000);
    const std::vector<Session> sessions = store.list();
    ASSERT_EQ(sessions.size(), 1u) << text;
    EXPECT_EQ(sessions[0].info, expected) << text;
    EXPECT_EQ(sessions[0].state, SessionState::complete);
    EXPECT_EQ(*parse_session_info(*read_file(json, 1 << 20)), expected) << "it is written again";
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_TRUE(reports[0].starts_with("session s: ") &&
                reports[0].ends_with("; its facts were taken from its MCAP files"))
        << reports[0];
    EXPECT_EQ(store.list().size(), 1u);
    EXPECT_EQ(reports.size(), 1u) << "once";
  }
}

TEST_F(Described, AMissingDescriptionIsWrittenAnew) {
  fs::remove(json);
  SessionStore store(folder.path(), 1'000'000'000);
  ASSERT_TRUE(store.find("s")) << store.find("s").error();
  EXPECT_EQ(store.find("s")->info.name, "half 1");
  EXPECT_TRUE(fs::exists(json));
  EXPECT_GT(store.size_bytes(), 0u);
  EXPECT_TRUE(store.remove("s"));
}

TEST_F(Described, AKeptSessionStaysKeptIfThatCanBeRead) {
  SessionStore store(folder.path(), 1'000'000'000);
  ASSERT_TRUE(store.keep("s", true));
  std::string text = *read_file(json, 1 << 20);
  std::ofstream(json, std::ios::trunc) << text.substr(0, text.find("\"name\""));
  EXPECT_TRUE(store.find("s")->info.kept);
}

TEST_F(Described, ASessionWithoutAnEndAndADescriptionIsRecovered) {
  fs::remove(json);
  const fs::path file = folder / "s/14.2.a.mcap";
  fs::resize_file(file, fs::file_size(file) - 20);
  EXPECT_EQ(SessionStore(folder.path(), 1'000'000'000).find("s")->state, SessionState::recovered);
}

TEST_F(Described, AFolderOfOtherFilesIsNoSession) {
  fs::create_directory(folder / "others");
  std::ofstream(folder / "others/film.mcap") << "no recording";
  SessionStore store(folder.path(), 0);
  EXPECT_EQ(store.list().size(), 1u);
  EXPECT_EQ(store.find("others").error(), "session: there is none called 'others'");
  EXPECT_FALSE(store.remove("others"));
}

}  // namespace
}  // namespace robot::logging
