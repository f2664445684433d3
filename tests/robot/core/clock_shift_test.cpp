#include "robot/core/clock_shift.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace robot {
namespace {

constexpr std::uint64_t kTime = 1'700'000'000 * kSecond;
constexpr std::int64_t kBy = -350'000'000;

TEST(ClockShift, AddsTheSameToEveryTime) {
  const ClockShift shift = kBy;
  EXPECT_EQ(shift(kTime), kTime - 350'000'000);
  EXPECT_EQ(shift(kTime + 7), shift(kTime) + 7);
  EXPECT_FALSE(shift.is_none());
  EXPECT_TRUE(ClockShift().is_none());
}

TEST(ClockShift, GrowsWithTheTime) {
  const ClockShift shift(kBy, 20e-6, kTime);
  EXPECT_EQ(shift(kTime), kTime - 350'000'000);
  EXPECT_EQ(shift(kTime + 3600 * kSecond), kTime + 3600 * kSecond - 350'000'000 + 72'000'000);
  EXPECT_EQ(shift(kTime - 3600 * kSecond), kTime - 3600 * kSecond - 350'000'000 - 72'000'000);
}

TEST(ClockShift, TheDriftOfADayIsTheMost) {
  const ClockShift shift(0, 1e-5, kTime);
  EXPECT_EQ(shift(kTime + 100 * 24 * 3600 * kSecond) - kTime - 100 * 24 * 3600 * kSecond, 864'000'000u);
  EXPECT_EQ(shift(0) + 864'000'000, 0u) << "a time of another clock, such as a monotonic one";
}

TEST(ClockShift, BackIsTheReverse) {
  for (const ClockShift& shift : {ClockShift(kBy), ClockShift(-kBy), ClockShift(kBy, 1e-4, kTime),
                                  ClockShift(-kBy, -1e-4, kTime + kSecond), ClockShift(0, 3e-5, kTime)})
    for (std::uint64_t after_ns = 0; after_ns < 7200 * kSecond; after_ns += 977'777'777'777) {
      const auto apart = static_cast<std::int64_t>(shift.back(shift(kTime + after_ns)) - (kTime + after_ns));
      EXPECT_LE(apart, 1);
      EXPECT_GE(apart, -1);
    }
}

TEST(ClockShift, ATimeBeforeTheBeginningOfTheOtherClockIsItsBeginning) {
  EXPECT_EQ(ClockShift(5).back(4), 0u);
  EXPECT_EQ(ClockShift(5).back(5), 0u);
  EXPECT_EQ(ClockShift(-5).back(4), 9u);
}

}  // namespace
}  // namespace robot
