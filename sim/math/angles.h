// Elementary functions that return the same bits on every machine.
//
// The C library picks FMA versions of its functions at run time, so their results differ between processors. `sim` uses
// none of them except `sqrt`, which is exact everywhere. Each function here is odd or even to the bit, as in
// mathematics, so that a mirrored start leads to the mirrored game. Each one is a range reduction (Cody and Waite) and
// a minimax polynomial (Remez), without tables.
#pragma once

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>

namespace sim {

static_assert(FLT_EVAL_METHOD == 0, "floats must not be computed with more bits than they have");

inline constexpr float kPi = 3.14159265358979f;
inline constexpr float kDegrees = 57.2957795f;  // of one radian

/// Returns the sine with an absolute error of at most 1.2e-7 (2 ulp of 1), for |angle| <= 1000 rad.
float sin(float angle);
/// Returns the cosine, likewise.
float cos(float angle);
/// The sine and the cosine of an angle. Both together cost little more than one.
struct SinCos {
  float sin;
  float cos;
};
SinCos sin_cos(float angle);
/// Returns the angle of the point (x, y) in [-π, π] rad, within 3.2e-7 rad. Returns 0 for (0, 0), and π for a negative
/// `x` with `y` = 0 or -0. It returns -π only when an angle slightly above -π is rounded.
float atan2(float y, float x);
/// Returns the natural logarithm, within 2 ulp, for normal numbers > 0.
float log(float x);
/// Returns e to the power of `x`, within 2 ulp, for -87 <= x <= 88. Values beyond are clamped.
float exp(float x);

/// Returns the equal angle in (-π, π], for |angle| <= 1000 rad. An angle in that range is returned unchanged.
float normalized(float angle);

// The implementations are inline because a step spends much of its time in them.

namespace detail {

// Adding this rounds to a whole number. Ties go to even, which is symmetric about 0. The low bits of the sum hold that
// number.
inline constexpr float kRound = 0x1.8p23f;

// π/2 in three parts. The first two have so few bits that their products with whole numbers up to 2000 are exact.
inline constexpr float kHalfPiHigh = 0x1.92p0f;
inline constexpr float kHalfPiMiddle = 0x1.fb4p-12f;
inline constexpr float kHalfPiLow = 0x1.4442d2p-24f;

/// Returns sine and cosine of `quarters` quarter turns plus `rest` in [-π/4, π/4] rad.
inline SinCos sin_cos_of_rest(float rest, std::uint32_t quarters) {
  const float square = rest * rest;
  const float sine = rest + rest * square * (-0x1.55554p-3f + square * (0x1.1105a8p-7f - square * 0x1.98d6b8p-13f));
  const float cosine =
      1.f - 0.5f * square + square * square * (0x1.55554ap-5f - square * (0x1.6c0c82p-10f - square * 0x1.99ff4p-16f));

  // an odd number of quarters swaps the two, the second bit changes the signs; bit operations, because the branch
  // predictor could not foresee either
  const std::uint32_t swap = 0u - (quarters & 1u);
  const auto sine_bits = std::bit_cast<std::uint32_t>(sine), cosine_bits = std::bit_cast<std::uint32_t>(cosine);
  const std::uint32_t difference = (sine_bits ^ cosine_bits) & swap;
  return {std::bit_cast<float>((sine_bits ^ difference) ^ ((quarters & 2u) << 30)),
          std::bit_cast<float>((cosine_bits ^ difference) ^ (((quarters + 1u) & 2u) << 30))};
}

/// Returns sine and cosine of an angle whose number of quarter turns plus kRound is `shifted`.
inline SinCos sin_cos_shifted(float angle, float shifted) {
  const float quarters = shifted - kRound;
  const float rest = ((angle - quarters * kHalfPiHigh) - quarters * kHalfPiMiddle) - quarters * kHalfPiLow;
  return sin_cos_of_rest(rest, std::bit_cast<std::uint32_t>(shifted));
}

}  // namespace detail

inline SinCos sin_cos(float angle) { return detail::sin_cos_shifted(angle, angle * (2.f / kPi) + detail::kRound); }

inline float sin(float angle) { return sin_cos(angle).sin; }
inline float cos(float angle) { return sin_cos(angle).cos; }

inline float atan2(float y, float x) {
  const float across = std::fabs(y), along = std::fabs(x);
  const float longer = across > along ? across : along, shorter = across > along ? along : across;
  if (longer == 0) return 0;

  // the arc tangent of a slope of at most 1
  const float slope = shorter / longer;
  const float square = slope * slope, fourth = square * square;
  const float low = -0x1.5550f2p-2f + square * 0x1.98d61p-3f;
  const float middle = -0x1.1e3d88p-3f + square * 0x1.912bf4p-4f;
  const float high = -0x1.d947e4p-5f + square * (0x1.797d32p-6f - square * 0x1.1d6f7p-8f);
  const float angle = slope + slope * square * (low + fourth * (middle + fourth * high));

  // Move to the octant of the point: forward from the axis before it or back from the axis after it. Bit operations,
  // because the branch predictor could not foresee the octant.
  const std::uint32_t steep = across > along, behind = x < 0, right = y < 0;
  const float axis = std::bit_cast<float>(((0u - steep) & 0x3fc90fdbu) | ((0u - (behind & ~steep)) & 0x40490fdbu));
  const float turned = axis + std::bit_cast<float>(std::bit_cast<std::uint32_t>(angle) ^ ((steep ^ behind) << 31));
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(turned) ^ (right << 31));
}

inline float log(float x) {
  // x = 2^exponent * (1 + rest) with 1 + rest in [√½, √2)
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::int32_t exponent = static_cast<std::int32_t>(bits - 0x3f3504f3u) >> 23;
  const float rest = std::bit_cast<float>(bits - (static_cast<std::uint32_t>(exponent) << 23)) - 1.f;

  const float square = rest * rest, fourth = square * square;
  const float low = (0x1.55554ap-2f - rest * 0x1.00022p-2f) + square * (0x1.99a596p-3f - rest * 0x1.54788cp-3f);
  const float high = (0x1.226e4cp-3f - rest * 0x1.0ce07ap-3f) + square * (0x1.07d0dep-3f - rest * 0x1.41eddcp-4f);
  const float cubic = rest * square * (low + fourth * high);

  // the logarithm of 2 in two parts; the product with the first is exact
  const auto doublings = static_cast<float>(exponent);
  return doublings * 0x1.63p-1f + (rest - (0.5f * square - (cubic - doublings * 0x1.bd0106p-13f)));
}

inline float exp(float x) {
  const float clamped = x < -87.f ? -87.f : x > 88.f ? 88.f : x;
  const float shifted = clamped * 0x1.715476p0f + detail::kRound;
  const float doublings = shifted - detail::kRound;
  const float rest = (clamped - doublings * 0x1.63p-1f) + doublings * 0x1.bd0106p-13f;

  const float square = rest * rest;
  const float tail = (0x1.fffffcp-2f + rest * 0x1.55549p-3f) +
                     square * ((0x1.5558f4p-5f + rest * 0x1.123a6cp-7f) + square * 0x1.6a234cp-10f);
  const float power = 1.f + (rest + square * tail);
  return power * std::bit_cast<float>((std::bit_cast<std::uint32_t>(shifted) + 127u) << 23);
}

inline float normalized(float angle) {
  if (-kPi < angle && angle <= kPi) return angle;
  const float shifted = angle * (0.5f / kPi) + detail::kRound;
  const float turns = shifted - detail::kRound;
  const float rest = ((angle - turns * (4 * detail::kHalfPiHigh)) - turns * (4 * detail::kHalfPiMiddle)) -
                     turns * (4 * detail::kHalfPiLow);

  // rounding may leave the angle slightly outside (-π, π]
  if (rest > kPi) return rest - 2 * kPi;
  if (rest <= -kPi) return rest + 2 * kPi;
  return rest;
}

}  // namespace sim
