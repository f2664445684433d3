#include "robot/foresight/following.h"

#include <gtest/gtest.h>

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
  following.hear(told(kCaptain, 2, 9, kNow), kCaptain, kPlayer, kNow);
  EXPECT_EQ(following.choice().played(), 2);
  EXPECT_EQ(following.told_ns(), kNow);
  following.forget(false, kNow + Following::kStaleNs - 1);
  EXPECT_EQ(following.choice().played(), 2);
  following.forget(false, kNow + Following::kStaleNs);
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy);
  following.hear(told(kCaptain, 2, 9, kNow), kCaptain, kPlayer, kNow + Following::kStaleNs);
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy) << "an old word is none";
}

TEST(Following, PassesOverWhatItCannotPlayAndItsOwnEcho) {
  Following following(3);
  following.hear(told(kCaptain, 3, 9, kNow), kCaptain, kPlayer, kNow);
  following.hear(told(kPlayer, 1, 9, kNow), kCaptain, kPlayer, kNow);
  pb::Team silent;
  silent.add_teammates()->set_player(kCaptain);
  silent.mutable_teammates(0)->set_received_ns(kNow);
  following.hear(silent, kCaptain, kPlayer, kNow);
  EXPECT_EQ(following.choice().strategy, sim::agent::kNoStrategy);
}

TEST(Following, TheCaptainLeadsOnWithWhatItHeard) {
  Following following(3);
  following.hear(told(kCaptain, 2, 255, kNow), kCaptain, kPlayer, kNow);
  following.forget(true, kNow + 2 * Following::kStaleNs);
  EXPECT_EQ(following.choice().played(), 2) << "who leads forgets nothing";
  following.choose(1, kNow + 2 * Following::kStaleNs);
  EXPECT_EQ(following.choice().epoch, 0) << "one more than 255";
  EXPECT_EQ(following.choice().played(), 1);
  following.hear(told(kCaptain, 2, 255, kNow + 2 * Following::kStaleNs), kPlayer, kPlayer,
                 kNow + 2 * Following::kStaleNs);
  EXPECT_EQ(following.choice().played(), 1) << "an older choice";
}

}  // namespace
}  // namespace robot::foreseeing
