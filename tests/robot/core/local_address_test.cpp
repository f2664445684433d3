#include "robot/core/local_address.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>

#include "robot/core/files.h"
#include "tests/support/temporary_folder.h"

namespace robot {
namespace {

FileDescriptor make_socket() { return FileDescriptor(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)); }

TEST(LocalAddress, OnlyProgramsOfOurUserMayConnect) {
  const tests::TemporaryFolder folder;
  const auto address = LocalAddress::of(folder / "socket", "test");
  ASSERT_TRUE(address);
  const FileDescriptor listening = make_socket(), connecting = make_socket();
  EXPECT_FALSE(address->connect(connecting.get()));
  EXPECT_EQ(errno, ENOENT);
  ASSERT_TRUE(address->listen(listening.get(), 1));
  struct stat status {};
  ASSERT_EQ(::stat((folder / "socket").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  EXPECT_TRUE(address->connect(connecting.get()));

  const FileDescriptor second = make_socket();
  EXPECT_FALSE(address->listen(second.get(), 1));
  EXPECT_EQ(errno, EADDRINUSE);
}

TEST(LocalAddress, APathMustHaveOneTo107Bytes) {
  EXPECT_TRUE(LocalAddress::of(std::string(107, 'a'), "test"));
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{108}, std::size_t{5000}}) {
    const auto address = LocalAddress::of(std::string(bytes, 'a'), "test");
    ASSERT_FALSE(address);
    EXPECT_EQ(address.error(), "test: expected a path of 1 .. 107 bytes, got " + std::to_string(bytes));
  }
}

}  // namespace
}  // namespace robot
