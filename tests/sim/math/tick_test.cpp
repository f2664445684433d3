#include "sim/math/tick.h"

#include <gtest/gtest.h>

namespace {

TEST(Tick, TicksOfAnAgeAreTheAge) {
  for (sim::Tick now = 0; now < 40000; now += 7) EXPECT_EQ(sim::ticks(sim::age(now, 0)), now);
}

TEST(Tick, TicksAreTheNearestWholeNumber) {
  EXPECT_EQ(sim::ticks(0), 0u);
  EXPECT_EQ(sim::ticks(0.016f), 0u);
  EXPECT_EQ(sim::ticks(0.017f), 1u);
  EXPECT_EQ(sim::ticks(600), 18000u);
}

TEST(Tick, TheAgeOfKNeverIsVeryLong) {
  EXPECT_GT(sim::age(0, sim::kNever), 1e5f);
  EXPECT_GT(sim::age(36000, sim::kNever), sim::age(36000, 0));
}

}  // namespace
