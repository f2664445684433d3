#include "robot/logging/streams/stream_format.h"

#include <gtest/gtest.h>

#include "tests/support/test_channel.h"

namespace robot::logging {
namespace {

struct Stream : ::testing::Test {
  Stream() {
    EXPECT_TRUE(channel->write_bytes("hello", 7));
    const memory::VersionPtr version = channel->newest();
    bytes = channel_frame(channel->info()) + message_frame_head(*version) + std::string(version->bytes());
  }

  /// Reads all complete frames. Returns false after an Error.
  static bool drain(FrameParser& parser, std::vector<Frame>& frames) {
    while (true) {
      Result<std::optional<Frame>> frame = parser.next();
      if (!frame) return false;
      if (!*frame) return true;
      frames.push_back(std::move(**frame));
    }
  }

  ManualClock clock{9};
  std::shared_ptr<memory::RawChannel> channel = tests::make_channel(clock);
  std::string bytes;
};

TEST_F(Stream, ReturnsTheSameFramesForPiecesOfAnySize) {
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
    FrameParser parser;
    std::vector<Frame> frames;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      parser.feed(std::string_view(bytes).substr(at, piece));
      ASSERT_TRUE(drain(parser, frames));
    }
    ASSERT_EQ(frames.size(), 2u) << "pieces of " << piece;
    EXPECT_EQ(std::get<memory::ChannelInfo>(frames[0]), channel->info());
    EXPECT_EQ(std::get<Record>(frames[1]), (Record{.sequence = 1, .capture_ns = 7, .publish_ns = 9, .bytes = "hello"}));
  }
}

TEST_F(Stream, SurvivesEveryTruncation) {
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    FrameParser parser;
    std::vector<Frame> frames;
    parser.feed(std::string_view(bytes).substr(0, size));
    EXPECT_TRUE(drain(parser, frames));
    EXPECT_LT(frames.size(), 2u);
  }
}

TEST_F(Stream, SurvivesEveryFlippedByte) {
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ flip);
      FrameParser parser;
      std::vector<Frame> frames;
      parser.feed(damaged);
      drain(parser, frames);
      EXPECT_LE(frames.size(), 3u);
    }
}

TEST_F(Stream, RefusesFramesThatAreTooLarge) {
  FrameParser parser;
  parser.feed(std::string("\x02\xff\xff\xff\xff", 5));
  EXPECT_EQ(parser.next().error(), "stream: expected a frame of at most 8388608 bytes, got 4294967295");
}

}  // namespace
}  // namespace robot::logging
