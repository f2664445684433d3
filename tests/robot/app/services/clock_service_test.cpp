#include "robot/app/services/clock_service.h"

#include <gtest/gtest.h>

#include "robot/core/clock.h"

namespace robot::app {
namespace {

constexpr std::uint64_t kEpoch = 1'700'000'000 * kSecond;

TEST(ClockService, ReportsTheOffsetOfTheSystemClockToCaptureTime) {
  ClockService sampler(kEpoch);
  EXPECT_EQ(sampler.sample(5 * kSecond, kEpoch + 5 * kSecond).offset_ns(), 0);
  EXPECT_EQ(sampler.sample(6 * kSecond, kEpoch + 6 * kSecond + 7).offset_ns(), 7);
}

TEST(ClockService, ReportsStepsOfAnHourInBothDirections) {
  ClockService sampler(kEpoch);
  constexpr auto kHour = static_cast<std::int64_t>(3600 * kSecond);
  EXPECT_EQ(sampler.sample(1 * kSecond, kEpoch + 1 * kSecond).step_ns(), 0) << "the first sample has no step";
  EXPECT_EQ(sampler.sample(2 * kSecond, kEpoch + 2 * kSecond + kHour).step_ns(), kHour);
  EXPECT_EQ(sampler.sample(3 * kSecond, kEpoch + 3 * kSecond + kHour).step_ns(), 0) << "a step is reported once";
  EXPECT_EQ(sampler.sample(4 * kSecond, kEpoch + 4 * kSecond).step_ns(), -kHour);
}

TEST(ClockService, DoesNotReportSlewingAsAStep) {
  ClockService sampler(kEpoch);
  for (std::uint64_t second = 1; second < 100; ++second)
    EXPECT_EQ(sampler.sample(second * kSecond, kEpoch + second * (kSecond + kSecond / 2000)).step_ns(), 0);
}

}  // namespace
}  // namespace robot::app
