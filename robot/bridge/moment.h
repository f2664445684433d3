// A moment of a game, and the age of data at that moment.
#pragma once

#include <algorithm>
#include <cstdint>

namespace robot::bridge {

/// A moment of a live, simulated or recorded game.
struct Moment {
  std::uint64_t now_ns = 0;  // [ns since the epoch]
  double speed = 1;          // [game seconds per second] of a simulation

  /// Returns the game time since `then_ns` [ns], at most 30 years; 0 when `then_ns` is in the future.
  std::uint64_t since(std::uint64_t then_ns) const {
    constexpr double kMost = 1e18;
    const std::uint64_t passed_ns = now_ns > then_ns ? now_ns - then_ns : 0;
    return static_cast<std::uint64_t>(std::min(static_cast<double>(passed_ns) * speed, kMost));
  }

  /// Reports whether time has been moved back since `then_ns`, for example by a recording that starts again. Data that
  /// are written during the evaluation of a moment are at most a second later.
  bool is_before(std::uint64_t then_ns) const { return then_ns > now_ns + kAtOnceNs; }

  static constexpr std::uint64_t kAtOnceNs = 1'000'000'000;
};

}  // namespace robot::bridge
