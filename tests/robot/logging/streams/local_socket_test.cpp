// A logger in one process, a parser in another: both ends of a local socket.
#include "robot/logging/streams/local_socket.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "robot/core/local_address.h"
#include "robot/logging/streams/board.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

struct LocalSocket : ::testing::Test {
  /// A logger of what arrives at the far end, and the parser that takes it there.
  LoggingBoard::StreamId listen() {
    return board.start_parser(
        std::make_unique<LocalSocketInProvider>(path),
        {.destination = [this](const memory::ChannelInfo& info) -> Result<std::shared_ptr<memory::Channel>> {
           far = std::make_shared<memory::RawChannel>(info, clock);
           far_log = board.start_logger(far, std::make_unique<tests::KeepingProvider>(arrivals));
           return std::shared_ptr<memory::Channel>(far);
         },
         .pace = nullptr});
  }
  LoggingBoard::StreamId connect() { return board.start_logger(near, std::make_unique<LocalSocketOutProvider>(path)); }
  /// Connects as soon as somebody listens: a socket has its path a moment before it listens.
  FileDescriptor connect_as_stranger() {
    const auto address = LocalAddress::of(path, "test");
    FileDescriptor stranger;
    EXPECT_TRUE(tests::eventually([&] {
      stranger = FileDescriptor(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
      return static_cast<bool>(address->connect(stranger.get()));
    }));
    return stranger;
  }
  void wait_for_the_listener() { connect_as_stranger(); }

  const tests::TemporaryFolder folder;
  const std::filesystem::path path = folder / "ball";
  ManualClock clock{50};
  std::shared_ptr<memory::RawChannel> near = tests::make_channel(clock), far;
  std::shared_ptr<tests::Arrivals> arrivals = std::make_shared<tests::Arrivals>();
  LoggingBoard board;
  LoggingBoard::StreamId far_log = 0;
};

TEST_F(LocalSocket, CarriesAStreamFromOneMemoryToAnother) {
  const auto parser = listen();
  wait_for_the_listener();
  const auto logger = connect();
  const std::string image(614'400, 'y');
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(near->write_bytes(i % 2 ? image : "small", 10));
  arrivals->wait_for(20);
  EXPECT_EQ(board.stop(logger).dropped, 0u);
  EXPECT_EQ(board.stop(parser).messages, 20u);
  board.stop(far_log);
  EXPECT_EQ(far->info(), near->info());
  EXPECT_EQ(arrivals->records[1].bytes, image);
  EXPECT_EQ(arrivals->records[1].capture_ns, 10u);
}

TEST_F(LocalSocket, AWriterThatComesAgainIsReadOn) {
  const auto parser = listen();
  wait_for_the_listener();
  const auto first = connect();
  ASSERT_TRUE(near->write_bytes("one", 1));
  arrivals->wait_for(1);
  board.stop(first);
  const auto second = connect();  // begins with the newest, which is "one" again
  ASSERT_TRUE(near->write_bytes("two", 2));
  arrivals->wait_for(3);
  board.stop(second);
  board.stop(parser);
  board.stop(far_log);
  EXPECT_EQ(arrivals->records[2].bytes, "two");
}

TEST_F(LocalSocket, WithoutAListenerTheWriterSaysSoAndGoesOn) {
  ASSERT_TRUE(near->write_bytes("lost", 1));
  const auto logger = connect();
  ASSERT_TRUE(tests::eventually([&] { return board.status(logger).failing; }));
  const StreamStatus status = board.stop(logger);
  EXPECT_EQ(status.problem, "cannot connect to " + path.string() + ": No such file or directory");
}

TEST_F(LocalSocket, IsUsableByItsUserOnly) {
  const auto parser = listen();
  wait_for_the_listener();
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  board.stop(parser);
}

TEST_F(LocalSocket, AParserThatNobodyWritesToCanBeStopped) {
  const auto parser = listen();
  wait_for_the_listener();
  EXPECT_TRUE(board.stop(parser).ended);
}

TEST_F(LocalSocket, NonsenseEndsTheStreamWithASentence) {
  const auto parser = listen();
  const FileDescriptor stranger = connect_as_stranger();
  ASSERT_EQ(::write(stranger.get(), "GET / HTTP/1.1\r\n", 16), 16);
  ASSERT_TRUE(tests::eventually([&] { return board.status(parser).ended; }));
  EXPECT_NE(board.stop(parser).problem.find("stream: expected a frame"), std::string::npos);
}

}  // namespace
}  // namespace robot::logging
