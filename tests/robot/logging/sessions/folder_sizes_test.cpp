#include "robot/logging/sessions/folder_sizes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "tests/support/temporary_folder.h"

namespace robot::logging {
namespace {

struct ALogFolder : ::testing::Test {
  void add(const std::string& id, std::size_t bytes) {
    std::filesystem::create_directory(folder / id);
    ASSERT_TRUE(replace_file(folder / id / "session.json", ""));
    ASSERT_TRUE(replace_file(folder / id / "a.mcap", std::string(bytes, 'a')));
  }
  void append(const std::string& id, std::size_t bytes) {
    std::ofstream(folder / id / "a.mcap", std::ios::app) << std::string(bytes, 'a');
  }
  /// Returns a time when all files are settled, `more_ns` later.
  static std::uint64_t settled_ns(std::uint64_t more_ns = 0) { return system_ns() + 60 * kSecond + more_ns; }

  const tests::TemporaryFolder folder;
  FolderSizes sizes{folder.path()};
};

TEST_F(ALogFolder, ItsSizeIsThatOfItsSessions) {
  EXPECT_EQ(sizes.total(system_ns()), 0u);
  EXPECT_EQ(FolderSizes(folder / "none").total(system_ns()), 0u);
  add("one", 100);
  add("two", 20);
  std::filesystem::create_directory(folder / "no session");
  ASSERT_TRUE(replace_file(folder / "no session" / "large", std::string(5000, 'x')));
  std::filesystem::create_symlink(folder / "no session" / "large", folder / "one" / "link.mcap");
  EXPECT_EQ(sizes.total(system_ns()), 120u);
  append("two", 3);
  EXPECT_EQ(sizes.total(system_ns()), 123u);
  std::filesystem::remove_all(folder / "one");
  EXPECT_EQ(sizes.total(system_ns()), 23u);
}

TEST_F(ALogFolder, OldSessionsAreNotMeasuredAgain) {
  for (int i = 0; i < 20; ++i) add("old" + std::to_string(i), 10);
  const std::uint64_t later_ns = system_ns() + 2 * FolderSizes::kWatchedNs;
  EXPECT_EQ(sizes.total(later_ns), 200u);
  const std::uint64_t measured = sizes.measurements();
  for (std::uint64_t second = 0; second < 300; ++second) EXPECT_EQ(sizes.total(later_ns + second * kSecond), 200u);
  EXPECT_EQ(sizes.measurements(), measured);
}

TEST_F(ALogFolder, ASessionThatChangedInTheLastHourIsMeasuredOnceAMinute) {
  add("young", 10);
  EXPECT_EQ(sizes.total(settled_ns()), 10u);
  const std::uint64_t measured = sizes.measurements();
  for (std::uint64_t second = 0; second < 120; ++second) sizes.total(settled_ns(second * kSecond));
  EXPECT_LE(sizes.measurements(), measured + 2);
}

TEST_F(ALogFolder, ASessionThatIsWrittenIsMeasuredEachTimeAndAfterAPauseWithinAMinute) {
  add("live", 10);
  EXPECT_EQ(sizes.total(system_ns()), 10u);
  append("live", 5);
  EXPECT_EQ(sizes.total(system_ns()), 15u);
  EXPECT_EQ(sizes.total(settled_ns()), 15u);
  append("live", 5);
  EXPECT_EQ(sizes.total(settled_ns(FolderSizes::kLookNs)), 20u);
}

TEST_F(ALogFolder, FilesThatAreAddedToAnOldSessionAreFound) {
  add("old", 10);
  EXPECT_EQ(sizes.total(settled_ns()), 10u);
  ASSERT_TRUE(replace_file(folder / "old" / "b.mcap", "bb"));
  EXPECT_EQ(sizes.total(settled_ns(FolderSizes::kLookNs)), 12u);
}

}  // namespace
}  // namespace robot::logging
