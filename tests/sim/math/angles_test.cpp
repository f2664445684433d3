#include "sim/math/angles.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace {

using sim::kPi;

/// Calls see(x) for 200 000 numbers from `least` to `most` and their opposites.
template <class See>
void sweep(float least, float most, See&& see) {
  constexpr int kCount = 100000;
  for (int i = 0; i <= kCount; ++i) {
    const float x = least + (most - least) * (static_cast<float>(i) / kCount);
    see(x);
    see(-x);
  }
}

/// Returns the distance between neighbouring floats at `x`.
double ulp(double x) {
  const auto value = static_cast<float>(std::fabs(x));
  return static_cast<double>(std::nextafter(value, std::numeric_limits<float>::infinity())) -
         static_cast<double>(value);
}

std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }

TEST(Angles, SineAndCosineAreWithinTwoUlpOfOne) {
  double worst = 0;
  for (const float most : {0.01f, 1.f, 10.f, 1000.f})
    sweep(0, most, [&](float x) {
      worst = std::fmax(worst, std::fabs(sim::sin(x) - std::sin(static_cast<double>(x))));
      worst = std::fmax(worst, std::fabs(sim::cos(x) - std::cos(static_cast<double>(x))));
    });
  EXPECT_LE(worst, 1.2e-7);
}

TEST(Angles, SineIsOddAndCosineEvenToTheBit) {
  sweep(0.0001f, 1000, [](float x) {
    ASSERT_EQ(bits(sim::sin(-x)), bits(-sim::sin(x))) << x;
    ASSERT_EQ(bits(sim::cos(-x)), bits(sim::cos(x))) << x;
  });
}

TEST(Angles, BothAtOnceAreTheSameAsEach) {
  sweep(0, 100, [](float x) {
    const sim::SinCos both = sim::sin_cos(x);
    ASSERT_EQ(both.sin, sim::sin(x));
    ASSERT_EQ(both.cos, sim::cos(x));
  });
}

TEST(Angles, ArcTangentIsWithinItsErrorInAllDirections) {
  double worst = 0;
  for (const float radius : {1e-20f, 0.01f, 1.f, 1e15f})
    sweep(0, kPi, [&](float angle) {
      const float x = radius * std::cos(angle), y = radius * std::sin(angle);
      const double true_angle = std::atan2(static_cast<double>(y), static_cast<double>(x));
      worst = std::fmax(worst, std::fabs(sim::atan2(y, x) - true_angle));
    });
  EXPECT_LE(worst, 3.2e-7);
}

TEST(Angles, ArcTangentIsOddToTheBitAndNeverBeyondPi) {
  sweep(0.00001f, kPi, [](float angle) {
    const float x = std::cos(angle), y = std::sin(angle);
    ASSERT_EQ(bits(sim::atan2(-y, x)), bits(-sim::atan2(y, x))) << angle;
    ASSERT_LE(std::fabs(sim::atan2(y, x)), kPi);
  });
}

TEST(Angles, ArcTangentIsExactOnTheAxes) {
  EXPECT_EQ(sim::atan2(0, 0), 0);
  EXPECT_EQ(sim::atan2(-0.f, -0.f), 0);
  EXPECT_EQ(sim::atan2(0, 2), 0);
  EXPECT_EQ(sim::atan2(0, -2), kPi);
  EXPECT_EQ(sim::atan2(-0.f, -2), kPi) << "a mirrored robot on the middle line faces the same way";
  EXPECT_EQ(sim::atan2(2, 0), kPi / 2);
  EXPECT_EQ(sim::atan2(2, -0.f), kPi / 2);
  EXPECT_EQ(sim::atan2(-2, 0), -kPi / 2);
}

TEST(Angles, LogarithmIsWithinTwoUlp) {
  double worst = 0;
  const auto look = [&](float x) {
    const double logarithm = std::log(static_cast<double>(x));
    worst = std::fmax(worst, std::fabs(sim::log(x) - logarithm) / ulp(logarithm));
  };
  for (float x = 1.2e-38f; x < 1e38f; x *= 1.001f) look(x);
  for (int i = 0; i <= 200000; ++i) look(0.5f + static_cast<float>(i) * 7.5e-6f);
  EXPECT_LE(worst, 2);
  EXPECT_EQ(sim::log(1), 0);
}

TEST(Angles, ExponentialIsWithinTwoUlpAndClampedBeyond) {
  double worst = 0;
  const auto look = [&](float x) {
    const double power = std::exp(static_cast<double>(x));
    worst = std::fmax(worst, std::fabs(sim::exp(x) - power) / ulp(power));
  };
  sweep(0, 87, look);
  sweep(0, 1, look);
  EXPECT_LE(worst, 2);
  EXPECT_EQ(sim::exp(0), 1);
  EXPECT_EQ(sim::exp(1000), sim::exp(88));
  EXPECT_EQ(sim::exp(-1000), sim::exp(-87));
}

TEST(Angles, NormalizedIsTheSameDirectionInRange) {
  sweep(0, 1000, [](float x) {
    const float angle = sim::normalized(x);
    ASSERT_GT(angle, -kPi) << x;
    ASSERT_LE(angle, kPi) << x;
    ASSERT_NEAR(std::remainder(static_cast<double>(angle) - static_cast<double>(x), 2 * 3.14159265358979323846), 0,
                6e-7)
        << x;
  });
}

TEST(Angles, NormalizedIsOddToTheBitAndIdempotent) {
  sweep(0.001f, 1000, [](float x) {
    const float angle = sim::normalized(x);
    ASSERT_EQ(bits(sim::normalized(angle)), bits(angle)) << x;
    ASSERT_EQ(bits(sim::normalized(-x)), bits(angle == kPi ? kPi : -angle)) << x;
  });
  EXPECT_EQ(sim::normalized(kPi), kPi);
  EXPECT_EQ(sim::normalized(-kPi), kPi);
}

TEST(Angles, NormalizedTurnsMinusPiIntoPi) {
  const float beyond = std::nextafter(kPi, 4.f);
  EXPECT_NEAR(sim::normalized(beyond), -kPi, 1e-6);
  EXPECT_NEAR(sim::normalized(-beyond), kPi, 1e-6);
}

}  // namespace
