// Game time in decisions.
#pragma once

#include <cstdint>

namespace sim {

/// Number of a decision, 30 a second, counted from the start of the game, dead time included.
using Tick = std::uint32_t;
inline constexpr float kTicksPerSecond = 30;
inline constexpr float kTickDuration = 1.f / 30;  // [s]
/// The time of what never happened.
inline constexpr Tick kNever = 0xffffffff;

/// [s] since `then`; a very long time when it never happened.
constexpr float age(Tick now, Tick then) {
  return then == kNever ? 1e6f : static_cast<float>(now - then) * kTickDuration;
}
/// The nearest whole number of ticks, for 0 <= seconds < 1e8.
constexpr Tick ticks(float seconds) { return static_cast<Tick>(0.5f * (2 * seconds * kTicksPerSecond + 1)); }

}  // namespace sim
