// Limits of numbers, by value: std::min, std::max and std::clamp return references, which lanes cannot choose between.
#pragma once

namespace sim::motion {

/// Returns the lesser number, as std::min does.
constexpr float lesser(float a, float b) { return b < a ? b : a; }
/// Returns the greater number, as std::max does.
constexpr float greater(float a, float b) { return a < b ? b : a; }
/// Returns the nearest number in [low, high], as std::clamp does.
constexpr float clamped(float number, float low, float high) {
  return number < low ? low : high < number ? high : number;
}

}  // namespace sim::motion
