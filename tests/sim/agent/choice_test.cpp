#include "sim/agent/choice.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace sim::agent {
namespace {

TEST(Choice, EpochsAreOrderedAcrossTheirEnd) {
  for (int epoch = 0; epoch < 256; ++epoch)
    for (int later = 1; later < 128; ++later) {
      const auto before = static_cast<std::uint8_t>(epoch), after = static_cast<std::uint8_t>(epoch + later);
      ASSERT_TRUE(is_newer(after, before)) << epoch << " and " << later << " more";
      ASSERT_FALSE(is_newer(before, after));
    }
  EXPECT_FALSE(is_newer(7, 7));
  EXPECT_FALSE(is_newer(7, 135));
  EXPECT_FALSE(is_newer(135, 7)) << "128 apart, neither";
}

TEST(Choice, ARobotWithoutAChoiceTakesTheFirstItHears) {
  Choice own;
  EXPECT_EQ(own.played(), 0);
  EXPECT_FALSE(follow({}, true, own)) << "a robot without a choice sends none";
  EXPECT_TRUE(follow({2, 200}, false, own));
  EXPECT_EQ(own.played(), 2);
}

TEST(Choice, FollowsTheNewerEpochAndTheCaptainOnTheSame) {
  Choice own{1, 5};
  EXPECT_FALSE(follow({2, 4}, true, own)) << "older";
  EXPECT_FALSE(follow({2, 5}, false, own)) << "a follower with the same epoch does not count";
  EXPECT_EQ(own.strategy, 1);
  EXPECT_TRUE(follow({2, 5}, true, own));
  EXPECT_EQ(own.strategy, 2);
  EXPECT_TRUE(follow({3, 6}, false, own)) << "a teammate heard it first";
  EXPECT_EQ(own.strategy, 3);
}

TEST(Choice, ADroppedChoiceReturnsOnlyByTheCaptainOrANewerEpoch) {
  Choice own{1, 5};
  let_go(own);
  EXPECT_EQ(own.played(), 0);
  EXPECT_FALSE(follow({1, 5}, false, own)) << "a follower that has not let go yet";
  EXPECT_FALSE(follow({2, 4}, false, own));
  Choice again = own, anew = own, begun_anew = own;
  EXPECT_TRUE(follow({1, 5}, true, again));
  EXPECT_TRUE(follow({2, 6}, false, anew));
  EXPECT_TRUE(follow({2, 1}, true, begun_anew)) << "a captain that was switched off and on counts from the beginning";
  choose(3, own);
  EXPECT_EQ(own.epoch, 6) << "its own choice is a newer one";
}

TEST(Choice, OnlyAnotherStrategyBeginsANewEpoch) {
  Choice own{1, 255};
  choose(1, own);
  EXPECT_EQ(own.epoch, 255);
  choose(0, own);
  EXPECT_EQ(own.strategy, 0);
  EXPECT_EQ(own.epoch, 0);
}

/// After the captain has chosen and each robot has heard all others once, the team agrees, regardless of earlier messages
/// and of other robots that believed to be the captain.
TEST(Choice, TheTeamAgreesAfterOneRoundOfMessages) {
  std::mt19937 random(1);
  const auto any = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Choice> team(5);
    for (int i = 0; i < 100; ++i) {
      const auto one = static_cast<std::size_t>(any(5)), other = static_cast<std::size_t>(any(5));
      if (any(10) == 0)
        choose(static_cast<std::uint8_t>(any(4)), team[one]);
      else if (one != other)
        follow(team[one], one == 1, team[other]);
    }
    // the captain hears all, chooses, and all hear it
    for (const std::size_t mate : {0u, 2u, 3u, 4u}) follow(team[mate], false, team[1]);
    choose(static_cast<std::uint8_t>(any(4)), team[1]);
    for (const std::size_t mate : {0u, 2u, 3u, 4u}) {
      follow(team[1], true, team[mate]);
      ASSERT_EQ(team[mate].played(), team[1].played()) << "trial " << trial;
    }
  }
}

}  // namespace
}  // namespace sim::agent
