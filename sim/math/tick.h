// Game time in ticks of 1/30 s.
#pragma once

#include <cstdint>

namespace sim {

/// The number of a tick, counted from the start of the game, dead time included. There are 30 ticks a second.
using Tick = std::uint32_t;
inline constexpr float kTicksPerSecond = 30;
inline constexpr float kTickDuration = 1.f / 30;  // [s]
/// The tick of an event that never happened.
inline constexpr Tick kNever = 0xffffffff;

/// Returns the time since `then` [s], or 1e6 s when `then` is kNever.
constexpr float age(Tick now, Tick then) {
  return then == kNever ? 1e6f : static_cast<float>(now - then) * kTickDuration;
}
/// Returns the nearest whole number of ticks, for 0 <= seconds < 1e8.
constexpr Tick ticks(float seconds) { return static_cast<Tick>(0.5f * (2 * seconds * kTicksPerSecond + 1)); }

}  // namespace sim
