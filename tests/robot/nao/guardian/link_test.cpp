// Guardian and runtime exchange messages, and neither waits for the other.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <cstring>
#include <vector>

#include "robot/core/local_address.h"
#include "robot/nao/guardian/guardian_client.h"
#include "robot/nao/guardian/runtime_link.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/used_up_descriptors.h"

namespace robot::nao {
namespace {

struct NaoLink : ::testing::Test {
  NaoLink() : link(std::move(*RuntimeLink::open(path))) {}

  GuardianClient client() { return std::move(*GuardianClient::open(path)); }

  /// Returns a connection that may send any bytes.
  FileDescriptor stranger() {
    FileDescriptor socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
    EXPECT_TRUE(LocalAddress::of(path, "test")->connect(socket.get()));
    return socket;
  }
  static Order order(float yaw) {
    Order order;
    order.position[head_yaw] = yaw;
    return order;
  }

  tests::TemporaryFolder folder;
  const std::filesystem::path path = folder / "link";
  RuntimeLink link;
};

TEST_F(NaoLink, ReceivesTheNewestOrderAndEveryRequest) {
  GuardianClient runtime = client();
  EXPECT_FALSE(link.hear().order);
  ASSERT_TRUE(runtime.give(order(1)) && runtime.give(order(2)));
  RuntimeLink::Heard heard = link.hear();
  ASSERT_TRUE(heard.order);
  EXPECT_EQ(heard.order->position[head_yaw], 2);
  EXPECT_FALSE(heard.asked_soft);
  ASSERT_TRUE(client().ask(Request::What::sit_and_soft));
  EXPECT_TRUE(link.hear().asked_soft) << "also from a client that has disconnected since";
}

TEST_F(NaoLink, DistinguishesAGoodbyeFromACrash) {
  {
    GuardianClient runtime = client();
    ASSERT_TRUE(runtime.give({}) && link.hear().order);
    ASSERT_TRUE(runtime.ask(Request::What::goodbye));
  }
  RuntimeLink::Heard heard = link.hear();
  EXPECT_TRUE(heard.runtime_left);
  EXPECT_FALSE(heard.runtime_crashed);
  { ASSERT_TRUE(client().give({})); }
  heard = link.hear();
  EXPECT_TRUE(heard.runtime_crashed);
  EXPECT_FALSE(heard.order) << "the order of a runtime that is gone";
  { client(); }
  heard = link.hear();
  EXPECT_FALSE(heard.runtime_crashed || heard.runtime_left) << "a client without an order was no runtime";
}

TEST_F(NaoLink, ReadsAllMessagesOfAClientThatLeftWithUnreadReports) {
  for (const auto what : {Request::What::sit_and_soft, Request::What::goodbye}) {
    {
      GuardianClient runtime = client();
      ASSERT_TRUE(runtime.give({}) && link.hear().order);
      link.tell({});
      ASSERT_TRUE(runtime.ask(what));
    }
    const RuntimeLink::Heard heard = link.hear();
    EXPECT_EQ(heard.asked_soft, what == Request::What::sit_and_soft);
    EXPECT_EQ(heard.runtime_left, what == Request::What::goodbye);
    EXPECT_EQ(heard.runtime_crashed, what != Request::What::goodbye);
  }
}

TEST_F(NaoLink, ObeysOneRuntimeAtATime) {
  GuardianClient other = client();
  {
    GuardianClient runtime = client();
    ASSERT_TRUE(runtime.give(order(1)) && link.hear().order);
    ASSERT_TRUE(other.give(order(2)));
    EXPECT_FALSE(link.hear().order);
  }
  ASSERT_TRUE(link.hear().runtime_crashed);
  ASSERT_TRUE(other.give(order(3)));
  EXPECT_TRUE(link.hear().order);
}

TEST_F(NaoLink, SilentClientsKeepNoRuntimeOutAndNoRequestIsLost) {
  std::vector<FileDescriptor> silent;
  for (std::size_t i = 0; i < RuntimeLink::kMaxConnections; ++i) silent.push_back(stranger());
  link.hear();
  GuardianClient runtime = client();
  ASSERT_TRUE(runtime.give(order(1)));
  EXPECT_TRUE(link.hear().order);
  char byte = 0;
  EXPECT_EQ(::recv(silent.front().get(), &byte, 1, 0), 0) << "the oldest made room";

  // a request that waits while others connect, and the runtime stays
  const Request request{.what = Request::What::sit_and_soft};
  ASSERT_EQ(::send(silent[1].get(), &request, sizeof request, 0), static_cast<ssize_t>(sizeof request));
  for (FileDescriptor& one : silent) one = stranger();
  ASSERT_TRUE(runtime.give(order(2)));
  const RuntimeLink::Heard heard = link.hear();
  EXPECT_TRUE(heard.asked_soft);
  EXPECT_TRUE(heard.order);
  EXPECT_FALSE(heard.runtime_crashed);
}

TEST_F(NaoLink, WithoutFileDescriptorsItAcceptsNothingForAWhile) {
  if (!tests::kCanUseUpDescriptors) GTEST_SKIP() << "the sanitizer itself needs file descriptors";
  const FileDescriptor waiting(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
  std::vector<pollfd> files;
  {
    const tests::UsedUpDescriptors none;
    ASSERT_TRUE(LocalAddress::of(path, "test")->connect(waiting.get()));
    link.hear();
    link.add_to(files);
    EXPECT_LT(files.front().fd, 0);
  }
  ASSERT_TRUE(tests::eventually([&] {
    files.clear();
    link.add_to(files);
    return files.front().fd >= 0;
  }));
  link.hear();
  files.clear();
  link.add_to(files);
  EXPECT_EQ(files.size(), 2u) << "then it accepts the client";
}

TEST_F(NaoLink, DropsAClientWithAnotherLayout) {
  Order wrong = order(1);
  wrong.layout = 99;
  const std::string long_one(5000, 'x');
  for (const auto& [bytes, size] :
       {std::pair<const void*, std::size_t>{&wrong, sizeof wrong}, {long_one.data(), long_one.size()}, {&wrong, 3}}) {
    const FileDescriptor socket = stranger();
    ASSERT_EQ(::send(socket.get(), bytes, size, 0), static_cast<ssize_t>(size));
    EXPECT_FALSE(link.hear().order);
    char byte = 0;
    EXPECT_EQ(::recv(socket.get(), &byte, 1, 0), 0) << "the connection ended";
  }
}

TEST_F(NaoLink, SendsEveryReportAndNeverWaitsForAClientThatDoesNotRead) {
  GuardianClient sleeper = client(), runtime = client();
  link.hear();
  Report report;
  for (std::uint64_t i = 1; i <= 10'000; ++i) {
    report.frames = i;
    link.tell(report);
    const auto next = runtime.next(0);
    ASSERT_TRUE(next && *next);
    EXPECT_EQ((*next)->frames, i);
  }
  std::uint64_t kept = 0;
  for (auto old = sleeper.next(0); old && *old; old = sleeper.next(0)) EXPECT_EQ((*old)->frames, ++kept);
  EXPECT_GT(kept, 0u);
  EXPECT_LT(kept, 100u) << "it missed the other reports";
}

TEST_F(NaoLink, ReportsAMissingGuardian) {
  const auto none = GuardianClient::open(folder / "none");
  EXPECT_EQ(none.error(), "guardian: expected foresight-guardian to listen at " + (folder / "none").string() +
                              ", got No such file or directory; start it first");
  GuardianClient runtime = client();
  link = std::move(*RuntimeLink::open(folder / "another"));
  EXPECT_EQ(runtime.next(0).error(), "guardian: the connection ended");
  EXPECT_FALSE(runtime.give({}));
}

TEST_F(NaoLink, IsForThisUserOnly) {
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  EXPECT_FALSE(RuntimeLink::open(path)) << "and for one guardian";
}

}  // namespace
}  // namespace robot::nao
