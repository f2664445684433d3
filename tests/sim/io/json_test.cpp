// Numbers as text.
#include "sim/io/json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace sim::io {
namespace {

TEST(ShortText, HasTheDigitsThatPeopleWrite) {
  EXPECT_EQ(short_text(0), "0");
  EXPECT_EQ(short_text(0.1f), "0.1");
  EXPECT_EQ(short_text(-2.5f), "-2.5");
  EXPECT_EQ(short_text(100'000), "100000");
  EXPECT_EQ(short_text(1e6f), "1e+06");
  EXPECT_EQ(short_text(1.0f / 3), "0.33333334");
  EXPECT_EQ(short_text(std::numeric_limits<float>::max()), "3.4028235e+38");
  EXPECT_EQ(short_text(std::nanf("")), "nan");
}

TEST(ShortText, DistinguishesEveryFloat) {
  std::uint32_t bits = 1;
  for (int i = 0; i < 100'000; ++i) {
    bits = 1664525 * bits + 1013904223;
    const auto value = std::bit_cast<float>(bits);
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(std::strtof(short_text(value).c_str(), nullptr), value);
    EXPECT_EQ(static_cast<float>(short_number(value)), value);
  }
}

}  // namespace
}  // namespace sim::io
