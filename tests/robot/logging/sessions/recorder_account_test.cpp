// The account of a recording: each message is in a file that a reader reads, or it is counted as lost, once. Each call for
// files fails in turn, in recordings whose folder stays, is moved or is deleted.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <functional>
#include <future>
#include <optional>
#include <set>

#include "tests/support/eventually.h"
#include "tests/support/failing_files.h"
#include "tests/support/recording.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

namespace fs = std::filesystem;
using tests::FileCall;

constexpr int kForGood = 1'000'000;

enum class Folder { stays, is_moved, is_deleted };

/// A recording with an account of its own.
struct Books {
  Books() {
    add("/14/2/small", 10);
    add("/14/2/large", 300'000);  // fills a chunk
    add("/14/2/empty", 0);
  }
  ~Books() { tests::mend_files(); }

  void add(const std::string& topic, std::size_t bytes) {
    objects.emplace_back(tests::make_channel(clock, topic), bytes);
    ASSERT_TRUE(channels.add(objects.back().first));
  }

  void write(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i)
      for (const auto& [channel, bytes] : objects)
        ASSERT_TRUE(channel->write_bytes(std::string(bytes, 'x'), clock.now_ns() + i));
    written += count * objects.size();
  }

  /// Moves or deletes the folder of the session, and lets the recorder notice it.
  void change(Folder what) {
    const std::string session = recorder.status().session;
    if (what != Folder::stays) {
      // not rename(), which may fail here
      ASSERT_EQ(::renameat(AT_FDCWD, (folder / session).c_str(), AT_FDCWD, (folder / "moved").c_str()), 0);
    }
    if (what == Folder::is_deleted) remove(folder / "moved");
    clock.set(clock.now_ns() + kSecond);  // for another name
    recorder.tend();
    // a new session begins with the newest version, which the one before had to have too
    if (recorder.status().session != session) written += objects.size();
  }

  /// Removes a folder in which a logger may make a file meanwhile.
  static void remove(const fs::path& path) {
    ASSERT_TRUE(tests::eventually([&] {
      std::error_code failed;
      fs::remove_all(path, failed);
      return !failed;
    }));
  }

  /// Messages of the session in `at` that a reader finds.
  std::uint64_t stored_in(const fs::path& at) {
    std::uint64_t messages = 0;
    for (const fs::directory_entry& file : fs::directory_iterator(at)) {
      if (file.path().extension() != ".mcap" || fs::file_size(file.path()) == 0) continue;
      if (!FileInProvider(file.path()).open()) continue;  // its head is torn, so no message is in it
      std::set<std::uint64_t> numbers;
      const std::vector<Record> records = tests::read_stream(file.path());
      for (const Record& record : records) numbers.insert(record.sequence);
      EXPECT_EQ(numbers.size(), records.size()) << file.path() << ": no message is there twice";
      messages += records.size();
    }
    return messages;
  }

  /// Expects that each message is in a file or counted, in the recording and in each of its sessions.
  void expect_balance(const std::string& when) {
    SCOPED_TRACE(when);
    std::uint64_t stored = 0;
    for (const fs::directory_entry& session : fs::directory_iterator(folder.path())) {
      if (!session.is_directory()) continue;
      const std::uint64_t here = stored_in(session.path());
      const Result<Session> read = read_session(session.path());
      if (!read) continue;  // its begin failed
      ASSERT_TRUE(read->info.account) << session.path();
      EXPECT_EQ(read->info.account->messages, here) << session.path();
      EXPECT_TRUE(read->info.complete);
      stored += here;
    }
    const RecordingStatus last = recorder.status();
    EXPECT_EQ(stored + last.dropped, written) << stored << " stored, " << last.dropped << " counted as lost";
    if (last.dropped > 0) {
      EXPECT_NE(last.message, "");
    }
  }

  const tests::TemporaryFolder folder;
  ManualClock clock{tests::kNow};
  memory::Channels channels;
  LoggingBoard board;
  SessionStore store{folder.path(), 4'000'000'000};
  Recorder recorder{channels, board, store, clock, {}};
  std::vector<std::pair<std::shared_ptr<memory::RawChannel>, std::size_t>> objects;
  std::uint64_t written = 0;  // versions that a session had to have, once for each session
};

/// Records while `count` calls fail after `before` ones. Returns how many did.
int record(FileCall call, int before, int count, Folder what) {
  Books books;
  if (!books.recorder.start("half", "game")) return 0;
  tests::fail_files(call, before, count);
  books.write(5);
  books.change(what);
  books.write(5);
  books.recorder.tend();
  EXPECT_TRUE(books.recorder.stop());
  tests::mend_files();
  books.recorder.tend();  // writes the ends that the disk did not take
  books.expect_balance("call " + std::to_string(static_cast<int>(call)) + ", after " + std::to_string(before) +
                       " calls, " + std::to_string(count) + " fail");
  return tests::failed_files();
}

struct RecorderAccount : ::testing::TestWithParam<std::tuple<FileCall, Folder>> {};

TEST_P(RecorderAccount, BalancesWhicheverCallFails) {
  if (!tests::kCanFailFiles) GTEST_SKIP() << "the sanitizer has these functions itself";
  const auto [call, what] = GetParam();
  for (const int count : {1, 2, kForGood}) {
    int failed = 0;
    for (int before = 0; before == 0 || failed > 0; ++before) {
      failed = record(call, before, count, what);
      if (HasFailure()) return;
    }
  }
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<FileCall, Folder>>& test) {
  constexpr const char* kCalls[] = {"Create", "Append", "Cut", "Write", "Store", "Rename"};
  constexpr const char* kFolders[] = {"Stays", "IsMoved", "IsDeleted"};
  const auto [call, what] = test.param;
  return std::string(kCalls[static_cast<int>(call)]) + "Folder" + kFolders[static_cast<int>(what)];
}

/// Returns the status, or nothing if it waits for longer than any machine needs. The disk works again then.
std::optional<RecordingStatus> status_in_time(const Recorder& recorder) {
  std::future<RecordingStatus> status = std::async(std::launch::async, [&] { return recorder.status(); });
  if (status.wait_for(tests::kLongestWait) == std::future_status::ready) return status.get();
  tests::mend_files();
  return std::nullopt;
}

TEST(RecorderStatus, NeverWaitsForADiskThatStandsStill) {
  if (!tests::kCanFailFiles) GTEST_SKIP() << "the sanitizer has these functions itself";
  using State = RecordingStatus::State;
  Books books;
  const auto expect_status = [&](const std::function<void()>& work, State before, State after) {
    tests::stop_files();
    const std::future<void> done = std::async(std::launch::async, work);
    ASSERT_TRUE(tests::eventually([] { return tests::waiting_files() > 0; }));
    const std::optional<RecordingStatus> seen = status_in_time(books.recorder);
    ASSERT_TRUE(seen) << "status() waits for the disk";
    EXPECT_EQ(seen->state, before);
    tests::mend_files();
    done.wait();
    EXPECT_EQ(books.recorder.status().state, after);
  };
  expect_status([&] { EXPECT_TRUE(books.recorder.start("half", "game")); }, State::off, State::recording);
  expect_status([&] { books.write(5); }, State::recording, State::recording);
  expect_status(
      [&] {
        Books::remove(books.folder / books.recorder.status().session);
        books.recorder.tend();  // begins a new session
      },
      State::recording, State::recording);
  expect_status([&] { EXPECT_TRUE(books.recorder.stop()); }, State::recording, State::off);
}

INSTANTIATE_TEST_SUITE_P(Calls, RecorderAccount,
                         ::testing::Combine(::testing::Values(FileCall::create, FileCall::append, FileCall::cut,
                                                              FileCall::write, FileCall::store, FileCall::rename),
                                            ::testing::Values(Folder::stays, Folder::is_moved, Folder::is_deleted)),
                         name_of);

}  // namespace
}  // namespace robot::logging
