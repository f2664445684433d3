#include "robot/logging/streams/file_provider.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "robot/core/clock.h"
#include "tests/support/mcap_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

using tests::TemporaryFolder;

/// Returns the records of a file, and the first error as one more record.
std::vector<Record> records_of(FileInProvider& file) {
  std::vector<Record> records;
  while (true) {
    const auto record = file.read();
    if (record && !*record) return records;
    records.push_back(record ? **record : Record{.bytes = "damage: " + record.error()});
  }
}

/// Writes `count` messages "0", "1", … captured at 0, 10, … ns.
memory::ChannelInfo write_words(FileOutProvider& file, int count) {
  const ManualClock clock(7);
  const auto channel = tests::make_channel(clock);
  EXPECT_TRUE(file.open(channel->info()));
  for (int i = 0; i < count; ++i) {
    EXPECT_TRUE(channel->write_bytes(std::to_string(i), static_cast<std::uint64_t>(10 * i)));
    EXPECT_TRUE(file.write(channel->newest()));
  }
  return channel->info();
}

TEST(FileProvider, ReadsTheMessagesThatItWrote) {
  const TemporaryFolder folder;
  FileOutProvider out(folder / "a.mcap", {.first_channel_id = 5});
  const memory::ChannelInfo info = write_words(out, 3);
  ASSERT_TRUE(out.close());
  EXPECT_EQ(out.messages(), 3u);
  EXPECT_EQ(out.lost_afterwards(), 0u);
  EXPECT_EQ(out.size_bytes(), std::filesystem::file_size(folder / "a.mcap"));

  FileInProvider in(folder / "a.mcap");
  const auto read_info = in.open();
  ASSERT_TRUE(read_info) << read_info.error();
  EXPECT_EQ(*read_info, info);
  EXPECT_EQ(records_of(in), (std::vector<Record>{{1, 0, 7, "0"}, {2, 10, 7, "1"}, {3, 20, 7, "2"}}));
}

TEST(FileProvider, AnExistingFileIsNeverOverwritten) {
  const TemporaryFolder folder;
  FileOutProvider first(folder / "a.mcap", {}), second(folder / "a.mcap", {});
  write_words(first, 1);
  const auto opened = second.open({});
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error(), "cannot make " + (folder / "a.mcap").string() + ": File exists");
}

TEST(FileProvider, OpenMayBeCalledAgainAfterAnError) {
  const TemporaryFolder folder;
  FileOutProvider out(folder / "session/a.mcap", {});
  EXPECT_FALSE(out.open({}));
  std::filesystem::create_directory(folder / "session");
  EXPECT_TRUE(out.open({}));
}

TEST(FileProvider, AsksToBeFlushedWithinASecond) {
  const TemporaryFolder folder;
  FileOutProvider out(folder / "a.mcap", {});
  EXPECT_EQ(out.flush_due_ns(), OutProvider::kNever);
  const std::uint64_t before = monotonic_ns();
  write_words(out, 1);
  EXPECT_GE(out.flush_due_ns(), before + kSecond);
  EXPECT_LE(out.flush_due_ns(), monotonic_ns() + kSecond);
  EXPECT_EQ(out.messages(), 0u);
  EXPECT_TRUE(out.flush());
  EXPECT_EQ(out.messages(), 1u);
  EXPECT_EQ(out.flush_due_ns(), OutProvider::kNever);
}

TEST(FileProvider, ReadsAFileWhoseWriterDied) {
  const TemporaryFolder folder;
  {
    FileOutProvider out(folder / "a.mcap", {});
    write_words(out, 2);
    ASSERT_TRUE(out.flush());  // without close()
  }
  FileInProvider in(folder / "a.mcap");
  ASSERT_TRUE(in.open());
  const auto records = records_of(in);
  ASSERT_EQ(records.size(), 3u);
  EXPECT_EQ(records[1].bytes, "1");
  EXPECT_TRUE(records[2].bytes.starts_with("damage: a.mcap: ends at byte ")) << records[2].bytes;
}

TEST(FileProvider, SeeksTheNewestMessageBeforeATime) {
  const TemporaryFolder folder;
  for (const std::size_t chunk_bytes : {std::size_t{1}, std::size_t{1'000'000}}) {
    const auto path = folder / ("a" + std::to_string(chunk_bytes) + ".mcap");
    FileOutProvider out(path, {.chunk_bytes = chunk_bytes});
    write_words(out, 50);
    ASSERT_TRUE(out.close());
    FileInProvider in(path), whole(path);
    ASSERT_TRUE(in.open());
    ASSERT_TRUE(whole.open());
    const auto all = records_of(whole);
    for (std::uint64_t to_ns = 0; to_ns <= all.back().capture_ns + 20; to_ns += 3) {
      ASSERT_TRUE(in.seek(to_ns));
      const auto first_later = std::ranges::upper_bound(all, to_ns, {}, &Record::capture_ns);
      const auto expected = first_later == all.begin() ? first_later : first_later - 1;
      ASSERT_EQ(records_of(in), std::vector(expected, all.end())) << to_ns;
    }
  }
}

TEST(FileProvider, CancelEndsReading) {
  const TemporaryFolder folder;
  FileOutProvider out(folder / "a.mcap", {});
  write_words(out, 5);
  ASSERT_TRUE(out.close());
  FileInProvider in(folder / "a.mcap");
  ASSERT_TRUE(in.open());
  ASSERT_TRUE(in.read());
  in.cancel();
  EXPECT_TRUE(records_of(in).empty());
}

TEST(FileProvider, GivesTheReasonWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  FileInProvider missing(folder / "a.mcap"), directory(folder.path());
  EXPECT_EQ(missing.open().error(), "cannot read " + (folder / "a.mcap").string() + ": No such file or directory");
  EXPECT_EQ(directory.open().error(), "cannot read " + folder.path().string() + ": expected a file");
}

// a real file, on a disk that is full at every possible byte: a limit on the size of files simulates the full disk
TEST(FileProvider, AFullDiskIsAnErrorAndLeavesAGoodFile) {
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  const ManualClock clock(7);
  for (rlim_t room = 0; room < 200; room += 3) {
    const TemporaryFolder folder;
    const auto channel = tests::make_channel(clock);
    FileOutProvider out(folder / "a.mcap", {});
    ASSERT_TRUE(out.open(channel->info()));
    ASSERT_TRUE(channel->write_bytes("lost?", 1));
    ASSERT_TRUE(out.write(channel->newest()));
    const rlimit limit{out.size_bytes() + room, old_limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    const Result<void> flushed = out.flush();
    setrlimit(RLIMIT_FSIZE, &old_limit);
    EXPECT_EQ(out.size_bytes(), std::filesystem::file_size(folder / "a.mcap"));
    EXPECT_EQ(out.lost_afterwards(), flushed ? 0u : 1u);

    ASSERT_TRUE(channel->write_bytes("kept", 2));
    ASSERT_TRUE(out.write(channel->newest()));
    ASSERT_TRUE(out.close());
    FileInProvider in(folder / "a.mcap");
    ASSERT_TRUE(in.open());
    EXPECT_EQ(records_of(in).back().bytes, "kept");
    EXPECT_EQ(records_of(in).size(), 0u);
  }
  std::signal(SIGXFSZ, old_handler);
}

}  // namespace
}  // namespace robot::logging
