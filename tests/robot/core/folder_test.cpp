#include "robot/core/folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "tests/support/temporary_folder.h"

namespace robot {
namespace {

using Kind = FolderEntry::Kind;

TEST(Folders, ListTheirEntriesByNameAndFollowNoLink) {
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(replace_file(folder / "b", "12345"));
  ASSERT_EQ(::mkdir((folder / "a").c_str(), 0755), 0);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  ASSERT_EQ(::symlink("b", (folder / "link").c_str()), 0);
  const auto entries = list_folder(folder.path());
  ASSERT_TRUE(entries) << entries.error();
  ASSERT_EQ(entries->size(), 4u);
  EXPECT_EQ((*entries)[0].name, "a");
  EXPECT_EQ((*entries)[0].kind, Kind::folder);
  EXPECT_EQ((*entries)[1].kind, Kind::file);
  EXPECT_EQ((*entries)[1].size_bytes, 5u);
  EXPECT_NEAR(static_cast<double>((*entries)[1].changed_ns), static_cast<double>(system_ns()), 60e9);
  EXPECT_EQ((*entries)[2].kind, Kind::other) << "a link";
  EXPECT_EQ((*entries)[3].kind, Kind::other) << "a pipe";
}

TEST(Folders, TellAPlainFileFromAllElse) {
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(replace_file(folder / "file", ""));
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  ASSERT_EQ(::symlink("file", (folder / "link").c_str()), 0);
  EXPECT_TRUE(is_plain_file(folder / "file"));
  for (const char* name : {"pipe", "link", ".", "none"}) EXPECT_FALSE(is_plain_file(folder / name)) << name;
}

TEST(Folders, WithTooManyEntriesAreRefused) {
  const tests::TemporaryFolder folder;
  for (const char* name : {"a", "b", "c"}) ASSERT_TRUE(replace_file(folder / name, ""));
  EXPECT_EQ(list_folder(folder.path(), 3)->size(), 3u);
  EXPECT_EQ(list_folder(folder.path(), 2).error(),
            "cannot read " + folder.path().string() + ": expected at most 2 entries, got more");
}

TEST(Folders, NameTheFolderThatCannotBeRead) {
  const tests::TemporaryFolder folder;
  const std::string loop = (folder / "loop").string();
  ASSERT_EQ(::symlink("loop", loop.c_str()), 0);
  EXPECT_EQ(list_folder(loop).error(), "cannot read " + loop + ": Too many levels of symbolic links");
  EXPECT_EQ(list_folder(folder / "none").error(),
            "cannot read " + (folder / "none").string() + ": No such file or directory");
  EXPECT_FALSE(list_folder(folder / std::string(5'000, 'x')));
}

}  // namespace
}  // namespace robot
