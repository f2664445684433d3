#include "robot/logging/sessions/checksums.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <chrono>

#include "robot/core/files.h"
#include "robot/logging/mcap/format.h"
#include "tests/support/temporary_folder.h"

namespace robot::logging {
namespace {

struct AFolder : ::testing::Test {
  AFolder() {
    EXPECT_TRUE(replace_file(folder / "b.mcap", std::string(600'000, 'b')));
    EXPECT_TRUE(replace_file(folder / "session.json", "{}"));
  }
  const tests::TemporaryFolder folder;
  Checksums checksums;
};

TEST_F(AFolder, ItsFilesAreListedByNameWithSizesAndChecksums) {
  const auto files = checksums.of_folder(folder.path());
  ASSERT_TRUE(files) << files.error();
  ASSERT_EQ(files->size(), 2u);
  EXPECT_EQ((*files)[0].name, "b.mcap");
  EXPECT_EQ((*files)[1].name, "session.json");
  for (const SessionFile& file : *files) {
    const std::string bytes = *read_file(folder / file.name, 1 << 20);
    EXPECT_EQ(file.size_bytes, bytes.size());
    EXPECT_EQ(file.crc32, mcap::crc32(bytes));
  }
  EXPECT_FALSE(checksums.of_folder(folder / "none"));
}

TEST_F(AFolder, HiddenFilesLinksPipesAndSubfoldersAreLeftOut) {
  ASSERT_TRUE(replace_file(folder / ".hidden", "x"));
  std::filesystem::create_directory(folder / "sub");
  std::filesystem::create_symlink(folder / "session.json", folder / "link.json");
  ASSERT_EQ(::mkfifo((folder / "pipe.mcap").c_str(), 0600), 0);
  const auto files = checksums.of_folder(folder.path());
  ASSERT_TRUE(files) << files.error();
  EXPECT_EQ(files->size(), 2u);
}

TEST_F(AFolder, AChecksumIsComputedOnceWhileItsFileStaysTheSame) {
  ASSERT_TRUE(checksums.of_folder(folder.path()));
  EXPECT_EQ(checksums.bytes_read(), 600'002u);
  ASSERT_TRUE(checksums.of_folder(folder.path()));
  EXPECT_EQ(checksums.bytes_read(), 600'002u);

  // the same size and another time
  ASSERT_TRUE(replace_file(folder / "session.json", "[]"));
  std::filesystem::last_write_time(folder / "b.mcap",
                                   std::filesystem::file_time_type::clock::now() - std::chrono::seconds(5));
  const auto files = checksums.of_folder(folder.path());
  ASSERT_TRUE(files);
  EXPECT_EQ((*files)[1].crc32, mcap::crc32("[]"));
  EXPECT_EQ(checksums.bytes_read(), 2 * 600'002u);
}

TEST_F(AFolder, ACancelledRequestEndsSoonAndKeepsTheFilesThatAreDone) {
  int asked = 0;
  const auto stopped = checksums.of_folder(folder.path(), [&] { return ++asked > 1; });
  ASSERT_FALSE(stopped);
  EXPECT_NE(stopped.error().find("is not wanted any more"), std::string::npos);
  EXPECT_LT(checksums.bytes_read(), 600'000u);
}

}  // namespace
}  // namespace robot::logging
