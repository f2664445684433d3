#include "robot/foresight/following.h"

#include <gtest/gtest.h>

#include <tuple>

#include "robot/core/clock.h"

namespace robot::foreseeing {
namespace {

constexpr std::uint64_t kNow = 1000 * kSecond;
constexpr int kCaptain = 2, kPlayer = 4;

pb::Team told(std::uint32_t player, std::uint32_t strategy, std::uint32_t epoch, std::uint64_t received_ns) {
  pb::Team team;
  pb::Teammate& mate = *team.add_teammates();
  mate.set_player(player);
  mate.set_strategy(strategy);
  mate.set_epoch(epoch);
  mate.set_received_ns(received_ns);
  return team;
}

TEST(Following, FollowsTheCaptainUntilItIsSilentForLong) {
  Following following(3);
  EXPECT_EQ(following.choice().played(), 0);
  following.hear(told(kCaptain, 2, 9, kNow), kCaptain, kPlayer, {kNow});
  EXPECT_EQ(following.choice().played(), 2);
  EXPECT_EQ(following.told_ns(), kNow);
  following.forget({kNow + Following::kStaleNs - 1});
  EXPECT_EQ(following.choice().played(), 2);
  following.forget({kNow + Following::kStaleNs});
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy);
  following.hear(told(kCaptain, 2, 9, kNow), kCaptain, kPlayer, {kNow + Following::kStaleNs});
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy) << "an old message does not count";
}

TEST(Following, IgnoresUnknownStrategiesAndItsOwnEcho) {
  Following following(3);
  following.hear(told(kCaptain, 3, 9, kNow), kCaptain, kPlayer, {kNow});
  following.hear(told(kPlayer, 1, 9, kNow), kCaptain, kPlayer, {kNow});
  pb::Team silent;
  silent.add_teammates()->set_player(kCaptain);
  silent.mutable_teammates(0)->set_received_ns(kNow);
  following.hear(silent, kCaptain, kPlayer, {kNow});
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy);
}

TEST(Following, TheCaptainLeadsOnWithWhatItHeard) {
  Following following(3);
  following.hear(told(kCaptain, 2, 255, kNow), kCaptain, kPlayer, {kNow});
  following.forget({kNow + 2 * Following::kStaleNs}, 2 * Following::kStaleNs);
  EXPECT_EQ(following.choice().played(), 2) << "its own answer may still come";
  following.choose(1, kNow + 2 * Following::kStaleNs);
  EXPECT_EQ(following.choice().epoch, 0) << "one more than 255";
  EXPECT_EQ(following.choice().played(), 1);
  following.hear(told(kCaptain, 2, 255, kNow + 2 * Following::kStaleNs), kPlayer, kPlayer,
                 {kNow + 2 * Following::kStaleNs});
  EXPECT_EQ(following.choice().played(), 1) << "an older choice";
}

TEST(Following, TheCaptainsChoiceLapsesWhenNoAnswerConfirmsIt) {
  Following following(3);
  following.choose(2, kNow);
  constexpr std::uint64_t kPeriodNs = 10 * kSecond;
  following.forget({kNow + Following::kStaleNs + kPeriodNs - 1}, kPeriodNs);
  EXPECT_EQ(following.choice().played(), 2);
  following.forget({kNow + Following::kStaleNs + kPeriodNs}, kPeriodNs);
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy);
  following.choose(2, kNow + 2 * Following::kStaleNs);
  EXPECT_EQ(following.choice().epoch, 2) << "chosen anew";
}

TEST(Following, InAFastSimulationSecondsAreThoseOfTheGame) {
  Following following(3);
  following.hear(told(kCaptain, 2, 9, kNow), kCaptain, kPlayer, {kNow, 10});
  following.forget({kNow + Following::kStaleNs / 10 - 1, 10});
  EXPECT_EQ(following.choice().played(), 2);
  following.forget({kNow + Following::kStaleNs / 10, 10});
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy);
  following.hear(told(kCaptain, 2, 9, kNow), kCaptain, kPlayer, {kNow + Following::kStaleNs / 10, 10});
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy) << "an old message does not count";
}

TEST(Following, AfterTimeWasMovedBackItStartsAnew) {
  Following following(3);
  following.hear(told(kCaptain, 2, 9, kNow), kCaptain, kPlayer, {kNow});
  constexpr std::uint64_t kBegin = kNow - 500 * kSecond;
  following.forget({kBegin});
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy);
  EXPECT_EQ(following.told_ns(), 0u);
  following.hear(told(kCaptain, 2, 9, kNow), kCaptain, kPlayer, {kBegin});
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy) << "it is still in the future";
  following.hear(told(5, 1, 3, kBegin), kCaptain, kPlayer, {kBegin});
  EXPECT_EQ(following.choice().played(), 1) << "an earlier epoch is the first again";
}

/// Two robots hear each other every second, without a captain: the captain's last choice ends with its time.
TEST(Following, FollowersDoNotKeepAChoiceAliveAmongThemselves) {
  constexpr std::uint32_t kOther = 5;
  Following one(3), other(3);
  one.hear(told(kCaptain, 2, 9, kNow), kCaptain, kPlayer, {kNow});
  for (std::uint64_t now = kNow; now < kNow + 3 * Following::kStaleNs; now += kSecond / 2) {
    for (auto [from, to, sender, hearer] :
         {std::tuple{&one, &other, std::uint32_t{kPlayer}, int{kOther}}, std::tuple{&other, &one, kOther, kPlayer}}) {
      if (from->choice().strategy != sim::agent::kNoStrategy)
        to->hear(told(sender, from->choice().strategy, from->choice().epoch, now), kCaptain, hearer, {now});
      to->forget({now});
    }
  }
  EXPECT_EQ(one.choice().strategy, sim::agent::kNoStrategy);
  EXPECT_EQ(other.choice().strategy, sim::agent::kNoStrategy);
  const std::uint64_t later = kNow + 4 * Following::kStaleNs;
  one.hear(told(kCaptain, 2, 9, later), kCaptain, kPlayer, {later});
  EXPECT_EQ(one.choice().played(), 2) << "the captain is back";
}

}  // namespace
}  // namespace robot::foreseeing
