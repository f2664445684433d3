#include "robot/lab/relay/carried_channel.h"

#include <gtest/gtest.h>

#include "robot/lab/relay/topic_claims.h"

namespace robot::lab {
namespace {

struct Carried : testing::Test {
  ManualClock clock{1000};
  std::shared_ptr<memory::RawChannel> to =
      std::make_shared<memory::RawChannel>(memory::ChannelInfo{.topic = "/14/2/x", .message_encoding = "json"}, clock);
  CarriedChannel carried{to};

  std::uint64_t numbered(std::uint64_t sequence, std::uint64_t capture_ns = 5) {
    return carried.enter({.capture_ns = capture_ns,
                          .published = memory::Published{.sequence = sequence, .publish_ns = capture_ns + 1},
                          .bytes = std::to_string(sequence)});
  }
  std::uint64_t newest() const { return to->newest() ? to->newest()->sequence() : 0; }
};

TEST_F(Carried, AGapInTheNumbersIsCountedAndStaysAGap) {
  carried.connected(true, 0);
  EXPECT_EQ(numbered(500), 0u) << "messages before the subscription are not lost";
  EXPECT_EQ(newest(), 1u);
  EXPECT_EQ(numbered(501), 0u);
  EXPECT_EQ(numbered(505), 3u);
  EXPECT_EQ(newest(), 6u);
  EXPECT_EQ(to->newest()->publish_ns(), 6u);
  EXPECT_EQ(to->newest()->bytes(), "505");
}

TEST_F(Carried, TheFirstMessageOfANewConnectionIsWrittenOnce) {
  carried.connected(true, 0);
  numbered(7);
  carried.connected(false, 0);
  EXPECT_EQ(numbered(7), 0u);
  EXPECT_EQ(newest(), 1u);
  EXPECT_EQ(numbered(9), 1u) << "8 was published while there was no connection";
  EXPECT_EQ(newest(), 3u);
}

TEST_F(Carried, NumbersContinueAfterARestartOfTheRobot) {
  carried.connected(true, 0);
  numbered(500);
  carried.connected(true, 0);
  EXPECT_EQ(numbered(3), 2u) << "1 and 2 of the new run were lost";
  EXPECT_EQ(newest(), 4u);
}

TEST_F(Carried, WithoutNumbersOnlyTheFirstMessageOfAConnectionIsCompared) {
  carried.connected(true, 0);
  for (int i = 0; i < 2; ++i) carried.enter({.capture_ns = 5, .published = {}, .bytes = "same"});
  EXPECT_EQ(newest(), 2u);
  carried.connected(false, 0);
  carried.enter({.capture_ns = 5, .published = {}, .bytes = "same"});
  EXPECT_EQ(newest(), 2u);
  carried.enter({.capture_ns = 5, .published = {}, .bytes = "same"});
  EXPECT_EQ(newest(), 3u);
  EXPECT_EQ(to->newest()->publish_ns(), 1000u);
}

TEST_F(Carried, TimesAreShiftedByTheOffsetOfTheClock) {
  carried.connected(true, -100);
  numbered(1, 1000);
  EXPECT_EQ(to->newest()->capture_ns(), 900u);
  EXPECT_EQ(to->newest()->publish_ns(), 901u);
}

TEST(TopicClaims, ARobotOwnsItsTopicsAndOthersBelongToTheFirstLink) {
  TopicClaims claims;
  EXPECT_TRUE(claims.introduce("14/2", 1));
  EXPECT_TRUE(claims.claim("/truth/world", 1));
  EXPECT_TRUE(claims.claim("/14/3/ball", 1)) << "14/3 is not known yet";
  EXPECT_TRUE(claims.introduce("14/3", 2));
  EXPECT_FALSE(claims.holds("/14/3/ball", 1));
  EXPECT_FALSE(claims.claim("/14/3/pose", 1));
  EXPECT_TRUE(claims.claim("/14/3/ball", 2));
  EXPECT_TRUE(claims.holds("/14/3/ball", 2));
  EXPECT_FALSE(claims.claim("/14/2/ball", 2));
  EXPECT_FALSE(claims.claim("/truth/world", 2));
  EXPECT_TRUE(claims.holds("/truth/world", 1));
  EXPECT_FALSE(claims.introduce("14/3", 3)) << "each robot is relayed once";
  EXPECT_TRUE(claims.introduce("", 3)) << "a server without a robot";
}

}  // namespace
}  // namespace robot::lab
