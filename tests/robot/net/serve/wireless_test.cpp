#include "robot/net/serve/wireless.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include "robot/core/files.h"

namespace robot::net {
namespace {

/// Listens on a port of its own, on loopback.
struct Listening : testing::Test {
  Listening() {
    EXPECT_EQ(::bind(socket.get(), generic(), sizeof address), 0);
    EXPECT_EQ(::listen(socket.get(), 8), 0);
    socklen_t size = sizeof address;
    EXPECT_EQ(::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size), 0);
  }
  const sockaddr* generic() const { return reinterpret_cast<const sockaddr*>(&address); }

  /// A connection that is being made.
  FileDescriptor knock() const {
    FileDescriptor knocking(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    ::connect(knocking.get(), generic(), sizeof address);
    return knocking;
  }
  static bool answered(const FileDescriptor& knocking, int patience_ms) {
    pollfd waiting{.fd = knocking.get(), .events = POLLOUT, .revents = 0};
    return ::poll(&waiting, 1, patience_ms) == 1 && (waiting.revents & POLLHUP) == 0;
  }

  sockaddr_in address{.sin_family = AF_INET, .sin_port = 0, .sin_addr = {htonl(INADDR_LOOPBACK)}};
  FileDescriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
};

TEST_F(Listening, AnswersNothingOverASilentInterfaceUntilItMaySpeakAgain) {
  EXPECT_TRUE(answered(knock(), 60'000));
  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(Wireless({"lo"}).silence(socket.get()));
    const FileDescriptor knocking = knock();
    EXPECT_FALSE(answered(knocking, 200));  // it gets no refusal either
    ASSERT_TRUE(Wireless().silence(socket.get()));
    EXPECT_TRUE(answered(knocking, 60'000));  // the kernel asks again
  }
  ASSERT_TRUE(Wireless().silence(socket.get()));  // a second call has no effect
}

TEST_F(Listening, AnswersOverOtherInterfaces) {
  Wireless elsewhere({"no_such_interface"});
  ASSERT_TRUE(elsewhere.silence(socket.get()));
  EXPECT_TRUE(answered(knock(), 60'000));
}

TEST_F(Listening, LoopbackIsNoneOfTheInterfacesThatMayBeWireless) {
  ASSERT_TRUE(Wireless(std::vector<std::string>()).silence(socket.get()));
  const FileDescriptor knocking = knock();
  EXPECT_TRUE(answered(knocking, 60'000));
  const FileDescriptor taken(::accept4(socket.get(), nullptr, nullptr, SOCK_CLOEXEC));
  EXPECT_FALSE(Wireless(std::vector<std::string>()).carries(taken.get()));
}

TEST_F(Listening, AConnectionIsCarriedByTheInterfaceThatHasItsAddress) {
  const FileDescriptor knocking = knock();
  const FileDescriptor taken(::accept4(socket.get(), nullptr, nullptr, SOCK_CLOEXEC));
  EXPECT_TRUE(Wireless({"lo"}).carries(taken.get()));
  EXPECT_FALSE(Wireless({"no_such_interface"}).carries(taken.get()));
  EXPECT_FALSE(Wireless().carries(taken.get()));
}

}  // namespace
}  // namespace robot::net
