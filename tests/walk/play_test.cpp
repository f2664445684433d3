// From the tree to the joints: a strategy decides by beliefs about the physics, our body walks to the ball and kicks it.
#include "tests/walk/play.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace robot::nao {
namespace {

constexpr double kHit = 0.2;  // [m/s] a slower ball was missed, or only brushed

class StrategyInPhysics : public ::testing::TestWithParam<walk::Servos> {};

TEST_P(StrategyInPhysics, WalksToTheBallAndKicksItIntoTheGoal) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Played played = play_alone(GetParam(), seed, 60);
    EXPECT_EQ(played.trouble, "");
    EXPECT_FALSE(played.fell) << "robot " << seed;
    EXPECT_TRUE(played.scored) << "robot " << seed;
    const auto hits = std::ranges::count_if(played.kicks, [](double speed) { return speed > kHit; });
    EXPECT_GE(2 * hits, std::ssize(played.kicks)) << "robot " << seed << " misses more than it hits";
    EXPECT_GT(hits, 0) << "robot " << seed << " dribbled";
  }
}

INSTANTIATE_TEST_SUITE_P(BothClasses, StrategyInPhysics, ::testing::Values(walk::Servos::stiff, walk::Servos::soft),
                         [](const auto& tested) { return tested.param == walk::Servos::stiff ? "Stiff" : "Soft"; });

}  // namespace
}  // namespace robot::nao
