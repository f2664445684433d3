// Elementary functions that give the same bits on every machine.
//
// The C library's differ between processors (its run-time FMA dispatch), so `sim` never calls them; `sqrt` is exact
// everywhere and is the only one it may use. All are odd or even to the bit, as mathematics has it: a mirrored game
// is the mirrored game.
#pragma once

namespace sim {

inline constexpr float kPi = 3.14159265358979f;

/// For |angle| <= 1000 rad within 2 ulp of 1 (absolute error <= 2.4e-7).
float sin(float angle);
float cos(float angle);
/// Both at once, for little more than one.
struct SinCos {
  float sin;
  float cos;
};
SinCos sin_cos(float angle);
/// [rad] (-π, π], within 3e-7; 0 for (0, 0).
float atan2(float y, float x);
/// Natural, within 2 ulp for normal numbers > 0.
float log(float x);
/// Within 2 ulp for -87 <= x <= 88, clamped beyond.
float exp(float x);

/// `angle` as the equal one in (-π, π], for |angle| <= 1000 rad.
float normalized(float angle);

}  // namespace sim
