#include "robot/core/scratch_file.h"

#include <gtest/gtest.h>

#include <string_view>

#include "tests/support/temporary_folder.h"

namespace robot {
namespace {

Result<void> write(ByteSink& sink, std::string_view text) { return sink.append({&text, 1}); }

TEST(ScratchFile, HoldsWhatWasWrittenAndHasNoName) {
  const tests::TemporaryFolder folder;
  const auto file = ScratchFile::make(folder.path());
  ASSERT_TRUE(file) << file.error();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  const auto sink = *file->sink();
  EXPECT_TRUE(write(*sink, "one "));
  const auto early = *file->source();
  EXPECT_TRUE(write(*sink, "two"));
  const auto late = *file->source();
  EXPECT_EQ(*read_bytes(*early, 0, early->size()), "one ");
  EXPECT_EQ(*read_bytes(*late, 0, late->size()), "one two");
}

TEST(ScratchFile, OfAMissingFolderIsAnError) {
  const tests::TemporaryFolder folder;
  EXPECT_FALSE(ScratchFile::make(folder.path() / "missing"));
}

}  // namespace
}  // namespace robot
