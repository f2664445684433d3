#include "robot/lab/clocks/clock_offset.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace robot::lab {
namespace {

TEST(ClockOffset, HasAnErrorOfHalfTheRoundTripAtMost) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::uint64_t> delay(0, 50 * kMillisecond), start(kSecond, 1'000'000 * kSecond);
  std::uniform_int_distribution<std::int64_t> ahead(-900'000'000, 900'000'000);
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t true_ns = ahead(random);
    const std::uint64_t sent_ns = start(random), heard_ns = sent_ns + delay(random);
    const ClockOffset found =
        offset_by(sent_ns, heard_ns + static_cast<std::uint64_t>(true_ns), heard_ns + delay(random));
    EXPECT_LE(static_cast<std::uint64_t>(std::abs(found.offset_ns - true_ns)), found.error_ns) << "case " << i;
  }
}

TEST(ClockOffset, TheShortestRoundTripCounts) {
  const ClockOffset rough{.offset_ns = 5, .error_ns = 900}, fine{.offset_ns = 7, .error_ns = 100};
  EXPECT_EQ(better({}, rough).offset_ns, 5);
  EXPECT_EQ(better(rough, fine).offset_ns, 7);
  EXPECT_EQ(better(fine, rough).offset_ns, 7);
}

TEST(ClockOffset, SmallOffsetsStayOthersAreCorrectedAndLargeOnesRefused) {
  const std::uint64_t most_ns = 2 * kSecond;
  EXPECT_EQ(*correction({.offset_ns = 9'000'000, .error_ns = 0}, most_ns, "its"), 0);
  EXPECT_EQ(*correction({.offset_ns = -30'000'000, .error_ns = 20'000'000}, most_ns, "its"), 0);
  EXPECT_EQ(*correction({.offset_ns = 350'000'000, .error_ns = 400'000}, most_ns, "its"), -350'000'000);
  EXPECT_EQ(*correction({.offset_ns = -350'000'000, .error_ns = 400'000}, most_ns, "its"), 350'000'000);
  const auto refused = correction({.offset_ns = -2'500'000'000, .error_ns = 400'000}, most_ns, "14/3's");
  ASSERT_FALSE(refused);
  EXPECT_EQ(
      refused.error(),
      "14/3's clock is 2.500 s behind (± 0.4 ms), more than the 2 s of --max-clock-offset: set the clock right, or "
      "allow more");
}

}  // namespace
}  // namespace robot::lab
