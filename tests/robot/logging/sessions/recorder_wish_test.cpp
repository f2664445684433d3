// A recording that the disk does not permit yet: it begins when the disk does.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "robot/core/report.h"
#include "tests/support/eventually.h"
#include "tests/support/recording.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

namespace fs = std::filesystem;
using State = RecordingStatus::State;
using tests::Recording;
using tests::SmallDisk;

struct Wishing : Recording {
  /// Expects that a session in `logs` cannot begin, calls `mend`, and expects that it begins.
  template <class Mend>
  void expect_a_later_begin(const fs::path& logs, const std::string& problem, Mend&& mend) {
    SessionStore here(logs, 4'000'000'000);
    Recorder waiting(channels, board, here, clock, {});
    EXPECT_FALSE(waiting.start("half", "game"));
    EXPECT_EQ(waiting.status().state, State::off);
    const auto request = waiting.want("half", "game");
    ASSERT_TRUE(request) << request.error();
    EXPECT_EQ(waiting.status().request, *request);
    EXPECT_EQ(waiting.status().state, State::disk_full);
    EXPECT_EQ(waiting.status().message, "the recording begins when the disk permits it; " + problem);
    EXPECT_FALSE(waiting.start("other", "game")) << "one is wanted already";
    waiting.tend();
    EXPECT_EQ(waiting.status().state, State::disk_full);

    mend();
    waiting.tend();
    EXPECT_EQ(waiting.status().state, State::recording) << waiting.status().message;
    EXPECT_EQ(waiting.status().request, *request);
    write_ball(1);
    const Result<std::string> session = waiting.stop();
    ASSERT_TRUE(session);
    EXPECT_EQ(here.find(*session)->state, SessionState::complete);
    EXPECT_EQ(here.find(*session)->info.name, "half");
    EXPECT_EQ(tests::read_stream(logs / *session / "14.2.ball.mcap").size(), 1u);
  }
};

TEST_F(Wishing, ABeginThatIsPossibleIsAtOnce) {
  ASSERT_TRUE(recorder.want("half", "game"));
  EXPECT_EQ(recorder.status().state, State::recording);
  EXPECT_EQ(recorder.want("half", "game").error(),
            "recording: the session " + recorder.status().session + " is being recorded already");
}

TEST_F(Wishing, WrongUsageIsRefused) {
  EXPECT_EQ(recorder.want("", "all").error(), "recording profile: expected one of game, vision, full, got 'all'");
  EXPECT_EQ(recorder.want(std::string(5'000, 'x'), "game").error(),
            "session name: expected at most 100 bytes, got 5000");
  EXPECT_EQ(recorder.start(std::string(5'000, 'x'), "game").error(),
            "session name: expected at most 100 bytes, got 5000");
  EXPECT_EQ(recorder.status().state, State::off);
}

TEST_F(Wishing, VersionsBeforeTheBeginAreCountedAsDropped) {
  write_ball(0);  // before the request
  fs::create_symlink("loop", folder / "loop");
  SessionStore here(folder / "loop", 4'000'000'000);
  Recorder waiting(channels, board, here, clock, {});
  ASSERT_TRUE(waiting.want("half", "game"));
  EXPECT_EQ(waiting.status().dropped, 0u);
  for (int i = 1; i <= 10; ++i) write_ball(static_cast<float>(i));
  EXPECT_EQ(waiting.status().dropped, 9u) << "the session will begin with the newest";
  const auto late = tests::make_channel(clock, "/14/2/late");
  ASSERT_TRUE(channels.add(late));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(late->write_bytes("late", clock.now_ns()));
  EXPECT_EQ(waiting.status().dropped, 11u) << "an object that appears meanwhile";
  fs::remove(folder / "loop");
  waiting.tend();
  write_ball(11);
  EXPECT_EQ(waiting.status().dropped, 11u);
  const std::string session = *waiting.stop();
  const auto records = tests::read_stream(folder.path() / "loop" / session / "14.2.ball.mcap");
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].sequence, 11u);
}

TEST_F(Wishing, CanBeTakenBack) {
  fs::create_symlink("loop", folder / "loop");
  SessionStore here(folder / "loop", 4'000'000'000);
  Recorder waiting(channels, board, here, clock, {});
  ASSERT_TRUE(waiting.want("half", "game"));
  write_ball(1);
  EXPECT_EQ(*waiting.stop(), "") << "it never began";
  EXPECT_EQ(waiting.status().dropped, 1u);
  EXPECT_EQ(waiting.status().message, "no session could begin before the end of the recording; messages lost: 1");
  fs::remove(folder / "loop");
  waiting.tend();
  EXPECT_EQ(waiting.status().state, State::off);
  EXPECT_FALSE(fs::exists(folder / "loop"));
}

TEST_F(Wishing, BeginsWhenTheLogFolderCanBeUsed) {
  fs::create_symlink("loop", folder / "loop");
  SessionStore here(folder / "loop", 4'000'000'000);
  Recorder waiting(channels, board, here, clock, {});
  ASSERT_TRUE(waiting.want("half", "game"));
  const std::string message = waiting.status().message;
  EXPECT_TRUE(message.starts_with("the recording begins when the disk permits it; cannot make the folder ")) << message;
  EXPECT_TRUE(message.ends_with(": Too many levels of symbolic links")) << message;
}

TEST_F(Wishing, BeginsWhenALoopOfLinksIsGone) {
  fs::create_symlink("loop", folder / "loop");
  const std::string made = (folder / "loop" / session_folder_name(clock.now_ns(), "half", "game")).string();
  expect_a_later_begin(folder / "loop", "cannot make the folder " + made + ": Too many levels of symbolic links",
                       [&] { fs::remove(folder / "loop"); });
}

TEST_F(Wishing, BeginsWhenAFileInPlaceOfTheLogFolderIsGone) {
  std::ofstream(folder / "logs") << "x";
  const std::string made = (folder / "logs" / session_folder_name(clock.now_ns(), "half", "game")).string();
  expect_a_later_begin(folder / "logs", "cannot make the folder " + made + ": Not a directory",
                       [&] { fs::remove(folder / "logs"); });
}

TEST_F(Wishing, BeginsWhenThereIsRoom) {
  const SmallDisk disk(folder.path(), "size=30m");
  if (!disk.mounted) GTEST_SKIP() << "needs the right to mount a small tmpfs";
  tests::write_ballast(folder / "ballast", 28);
  expect_a_later_begin(folder / "logs", recorder.room_for(profiles().front()).sentence,
                       [&] { fs::remove(folder / "ballast"); });
}

TEST_F(Wishing, BeginsWhenTheDiskIsNoLongerReadOnly) {
  const SmallDisk disk(folder.path(), "size=60m", MS_RDONLY);
  if (!disk.mounted) GTEST_SKIP() << "needs the right to mount a small tmpfs";
  const std::string made = (folder / session_folder_name(clock.now_ns(), "half", "game")).string();
  expect_a_later_begin(folder.path(), "cannot make the folder " + made + ": Read-only file system",
                       [&] { ASSERT_EQ(mount("tmpfs", folder.path().c_str(), "tmpfs", MS_REMOUNT, "size=60m"), 0); });
}

// a folder of another user with mode 700 once ended the process
TEST_F(Wishing, AFolderThatCannotBeEnteredEndsNothing) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root, to become another user";
  fs::create_directory(folder / "logs");
  fs::permissions(folder / "logs", fs::perms::owner_all);
  fs::permissions(folder.path(), fs::perms::all);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (setuid(65534) != 0) _exit(3);
    const SessionClock clock_here;
    memory::Channels none;
    LoggingBoard board_here;
    for (const fs::path& logs : {folder / "logs", folder / "logs/inner"}) {
      SessionStore here(logs, 4'000'000'000);
      Recorder waiting(none, board_here, here, clock_here, {});
      if (!waiting.want("half", "game") || waiting.status().state != State::disk_full) _exit(1);
      if (waiting.status().message.find("Permission denied") == std::string::npos) _exit(2);
      if (!here.list().empty() || !here.make_room(1, 1).empty()) _exit(4);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

struct FullDisk : Recording {
  void SetUp() override {
    if (!disk.mounted) GTEST_SKIP() << "needs the right to mount a small tmpfs";
    ASSERT_TRUE(channels.add(blobs));
    ASSERT_TRUE(recorder.start("", "game"));
    write_blob();
    ASSERT_TRUE(tests::eventually([&] { return recorder.status().messages > 0; }));
    // fills the disk to the last byte, so that the session's own files cannot grow
    tests::write_ballast(folder / "ballast", 70);
    ASSERT_TRUE(eventually_while_writing([&] { return recorder.status().state == State::disk_full; }));
  }
  void write_blob() {
    std::string blob(3'000, '\0');
    for (char& c : blob) c = static_cast<char>(random());
    ASSERT_TRUE(blobs->write_bytes(blob, clock.now_ns()));
  }
  template <class Predicate>
  ::testing::AssertionResult eventually_while_writing(Predicate&& predicate) {
    return tests::eventually([&] {
      write_blob();
      return predicate();
    });
  }

  const SmallDisk disk{folder.path(), "size=60m"};
  std::mt19937 random{1};  // random bytes do not compress
  std::shared_ptr<memory::RawChannel> blobs = tests::make_channel(clock, "/14/2/blobs");
};

// small messages fill a chunk for a second: the state once said "recording" while each chunk was lost
TEST_F(FullDisk, ShowsInEverySampleUntilThereIsRoom) {
  const std::uint64_t dropped = recorder.status().dropped;
  ASSERT_TRUE(eventually_while_writing([&] {
    EXPECT_EQ(recorder.status().state, State::disk_full);
    return recorder.status().dropped > dropped + 1'000;
  }));
  EXPECT_NE(recorder.status().message.find("No space left on device"), std::string::npos) << recorder.status().message;
  fs::remove(folder / "ballast");
  ASSERT_TRUE(eventually_while_writing([&] { return recorder.status().state == State::recording; }));
}

TEST_F(FullDisk, IsOverForAStreamWithoutMessagesWhenOthersReachTheDisk) {
  // the last blobs are lost within a second
  const std::uint64_t written_ns = monotonic_ns();
  ASSERT_TRUE(tests::eventually([&] { return monotonic_ns() > written_ns + 2 * kSecond; }));
  fs::remove(folder / "ballast");
  EXPECT_EQ(recorder.status().state, State::disk_full);
  ASSERT_TRUE(tests::eventually([&] {
    write_ball(1);
    return recorder.status().state == State::recording;
  }));
}

}  // namespace
}  // namespace robot::logging
