#include "robot/core/clock.h"

#include <gtest/gtest.h>

namespace robot {
namespace {

TEST(SessionClock, IsTheMonotonicClockPlusAFixedOffset) {
  const SessionClock clock(1'000 * kSecond);
  const std::uint64_t before = monotonic_ns(), now = clock.now_ns(), after = monotonic_ns();
  EXPECT_LE(before + 1'000 * kSecond, now);
  EXPECT_GE(after + 1'000 * kSecond, now);
}

TEST(SessionClock, StartsAtTheSystemTime) {
  const std::uint64_t before = system_ns();
  const SessionClock clock;
  EXPECT_LT(clock.now_ns() - before, 10 * kSecond);
}

TEST(SessionClock, NeverDecreases) {
  const SessionClock clock;
  std::uint64_t last = 0;
  for (int i = 0; i < 100'000; ++i) {
    const std::uint64_t now = clock.now_ns();
    ASSERT_GE(now, last);
    last = now;
  }
}

TEST(ManualClock, ShowsTheTimeItWasSetTo) {
  ManualClock clock(5);
  EXPECT_EQ(clock.now_ns(), 5u);
  clock.set(7);
  EXPECT_EQ(clock.now_ns(), 7u);
}

}  // namespace
}  // namespace robot
