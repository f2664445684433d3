#include "robot/nao/walk/hip_sag.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::nao::walk {
namespace {

constexpr HipSag::Weights kOnLeft{1, 0}, kOnRight{0, 1}, kOnBoth{0.5, 0.5};

/// Lets a hip stand on `weights` whose joints give way by `sag` [rad]. Returns where they are.
Legs stood(HipSag& hips, const HipSag::Weights& weights, const std::array<double, 2>& sag, int ticks) {
  const Legs places{};
  Legs measured{};
  for (int i = 0; i < ticks; ++i) {
    Legs targets = places;
    hips.raise(places, weights, targets);
    for (const Side side : {left, right})
      measured[side][hip_roll] = targets[side][hip_roll] - weights[side] * sag[side];
    hips.see(measured, weights);
  }
  return measured;
}

TEST(HipSag, ACarryingHipComesToItsPlace) {
  const Parameters parameters;
  HipSag hips(parameters);
  const std::array<double, 2> sag{0.06, -0.03};
  EXPECT_NEAR(stood(hips, kOnLeft, sag, 1)[left][hip_roll], -0.06, 1e-12);
  EXPECT_NEAR(stood(hips, kOnLeft, sag, 1000)[left][hip_roll], 0, 1e-4);
  EXPECT_NEAR(stood(hips, kOnRight, sag, 1000)[right][hip_roll], 0, 1e-4);
  // each keeps its own, and a half weight needs half of it
  const Legs both = stood(hips, kOnBoth, sag, 1);
  EXPECT_NEAR(both[left][hip_roll], 0, 1e-4);
  EXPECT_NEAR(both[right][hip_roll], 0, 1e-4);
}

TEST(HipSag, TwoLegsOnTheGroundTeachNothing) {
  const Parameters parameters;
  HipSag hips(parameters);
  EXPECT_NEAR(stood(hips, kOnBoth, {0.06, 0.06}, 1000)[left][hip_roll], -0.03, 1e-12);
}

TEST(HipSag, IsBoundedAndLeavesTheOtherJoints) {
  const Parameters parameters;
  HipSag hips(parameters);
  stood(hips, kOnLeft, {1, 0}, 10'000);
  Legs targets{};
  hips.raise({}, kOnLeft, targets);
  EXPECT_DOUBLE_EQ(targets[left][hip_roll], parameters.sag_most);
  for (const Side side : {left, right})
    for (int joint = 0; joint < kLegJoints; ++joint)
      if (side == right || joint != hip_roll) {
        EXPECT_EQ(targets[side][static_cast<std::size_t>(joint)], 0);
      }
}

}  // namespace
}  // namespace robot::nao::walk
