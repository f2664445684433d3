#include "robot/logging/sessions/owned_folder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <optional>

#include "tests/support/temporary_folder.h"

namespace robot::logging {
namespace {

namespace fs = std::filesystem;

TEST(OwnedFolders, HaveANameOfTheirOwnAndAreOwnedUntilTheEnd) {
  const tests::TemporaryFolder folder;
  const fs::path logs = folder / "not/yet";
  {
    const auto first = OwnedFolder::make(logs, "half"), second = OwnedFolder::make(logs, "half");
    ASSERT_TRUE(first) << first.error();
    EXPECT_EQ(first->name(), "half");
    EXPECT_EQ(second->name(), "half_2");
    EXPECT_TRUE(is_owned(logs / "half"));
    EXPECT_EQ(OwnedFolder::own(logs / "half").error(), (logs / "half").string() + ": it is being recorded already");
  }
  EXPECT_FALSE(is_owned(logs / "half"));
  EXPECT_TRUE(fs::is_empty(logs / "half")) << "the lock file is removed";
  EXPECT_FALSE(is_owned(logs / "none"));
}

TEST(OwnedFolders, OfADeadProcessHaveNoOwner) {
  const tests::TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const auto owned = OwnedFolder::make(folder.path(), "half");
    (void)!write(ready[1], owned ? "x" : "-", 1);
    while (true) pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_EQ(byte, 'x');
  EXPECT_TRUE(is_owned(folder / "half"));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(folder / "half" / kLockFile));
  EXPECT_FALSE(is_owned(folder / "half"));
  EXPECT_TRUE(OwnedFolder::own(folder / "half"));
}

TEST(OwnedFolders, NoticeThatTheyAreDeletedMovedOrReplaced) {
  const tests::TemporaryFolder folder;
  const auto owned = OwnedFolder::make(folder.path(), "half");
  EXPECT_TRUE(owned->in_place());
  EXPECT_NE(owned->identity_of(kLockFile), 0u);
  fs::rename(folder / "half", folder / "moved");
  EXPECT_FALSE(owned->in_place());
  EXPECT_NE(owned->identity_of(kLockFile), 0u) << "its files are still there";
  fs::create_directory(folder / "half");
  EXPECT_FALSE(owned->in_place());
  fs::remove_all(folder / "moved");
  EXPECT_EQ(owned->identity_of(kLockFile), 0u);
}

TEST(OwnedFolders, NameTheFolderThatCannotBeMade) {
  const tests::TemporaryFolder folder;
  fs::create_symlink("loop", folder / "loop");
  EXPECT_EQ(OwnedFolder::make(folder / "loop", "half").error(),
            "cannot make the folder " + (folder / "loop/half").string() + ": Too many levels of symbolic links");
  EXPECT_FALSE(OwnedFolder::make(folder.path(), std::string(5'000, 'x')));
}

TEST(OwnedFolders, APipeOrALinkInPlaceOfTheLockFileBlocksNobody) {
  const tests::TemporaryFolder folder;
  fs::create_directory(folder / "half");
  fs::create_symlink("/dev/null", folder / "half" / kLockFile);
  EXPECT_FALSE(is_owned(folder / "half"));
  EXPECT_FALSE(OwnedFolder::own(folder / "half"));
}

TEST(OwnedFolders, AreDiscardedWithTheirLockFile) {
  const tests::TemporaryFolder folder;
  auto owned = OwnedFolder::make(folder.path(), "half");
  owned->discard();
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace robot::logging
