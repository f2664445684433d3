#include "robot/core/files.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.h"
#include "tests/support/used_up_descriptors.h"

namespace robot {
namespace {

TEST(Files, ReturnTheBytesThatWereWritten) {
  const tests::TemporaryFolder folder;
  std::string bytes(200'000, 'x');
  bytes[100'000] = '\0';
  ASSERT_TRUE(replace_file(folder / "a", bytes));
  const Result<std::string> read = read_file(folder / "a", 1 << 20);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, bytes);
}

TEST(Files, AreReplacedWithTheGivenModeAndLeaveNothingBeside) {
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(replace_file(folder / "token", "old", 0600));
  ASSERT_TRUE(replace_file(folder / "token", "new", 0600));
  EXPECT_EQ(*read_file(folder / "token", 100), "new");
  struct stat status {};
  ASSERT_EQ(::stat((folder / "token").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Files, AreReplacedByManyThreadsAtOnceAndHoldTheBytesOfOne) {
  const tests::TemporaryFolder folder;
  std::vector<std::thread> threads;
  for (const char letter : {'a', 'b', 'c', 'd'})
    threads.emplace_back([&folder, letter] {
      for (int i = 0; i < 200; ++i) {
        const Result<void> written = replace_file(folder / "run", std::string(10'000, letter));
        EXPECT_TRUE(written) << written.error();
      }
    });
  for (std::thread& thread : threads) thread.join();
  const Result<std::string> read = read_file(folder / "run", 1 << 20);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, std::string(10'000, read->front()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Files, ASpareDescriptorIsFreedWhenNoOtherIsLeft) {
  if (!tests::kCanUseUpDescriptors) GTEST_SKIP() << "the sanitizer itself needs file descriptors";
  FileDescriptor spare = spare_descriptor();
  ASSERT_TRUE(spare);
  const tests::UsedUpDescriptors none;
  errno = 0;
  EXPECT_FALSE(spare_descriptor());
  EXPECT_TRUE(is_out_of_descriptors(errno));
  EXPECT_FALSE(is_out_of_descriptors(EAGAIN));
  spare.reset();
  EXPECT_TRUE(spare_descriptor());
}

TEST(Files, AreStoredWithTheirNameAndLeaveNothingBeside) {
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(store_file(folder / "a", "old"));
  ASSERT_TRUE(store_file(folder / "a", "new"));
  EXPECT_EQ(*read_file(folder / "a", 100), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  const std::string path = (folder / "none" / "a").string();
  EXPECT_EQ(store_file(path, "").error(), "cannot write " + path + ": No such file or directory");
}

TEST(Files, NameTheFileThatCannotBeRead) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder / "missing").string();
  EXPECT_EQ(read_file(path, 10).error(), "cannot read " + path + ": No such file or directory");
}

TEST(Files, AreReadOnlyUpToTheGivenSize) {
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(replace_file(folder / "a", "12345"));
  EXPECT_TRUE(read_file(folder / "a", 5));
  EXPECT_EQ(read_file(folder / "a", 4).error(),
            "cannot read " + (folder / "a").string() + ": expected at most 4 bytes, got more");
}

}  // namespace
}  // namespace robot
